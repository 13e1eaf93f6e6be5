// Runs before all other scripts: it collects every error where the browser tests look for them.
document.body.dataset.errors = '';
window.addEventListener('error', (event) => { document.body.dataset.errors += event.message + '\n'; });
window.addEventListener('unhandledrejection', (event) => { document.body.dataset.errors += event.reason + '\n'; });
document.addEventListener('securitypolicyviolation', (event) => {
  document.body.dataset.errors += 'blocked: ' + event.violatedDirective + ' ' + event.blockedURI + '\n';
});
