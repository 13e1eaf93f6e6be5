// This script runs first. It collects the errors of all other scripts on the page, for the tests in browsers.
document.body.dataset.errors = '';
window.addEventListener('error', (event) => { document.body.dataset.errors += event.message + '\n'; });
window.addEventListener('unhandledrejection', (event) => { document.body.dataset.errors += event.reason + '\n'; });
document.addEventListener('securitypolicyviolation', (event) => {
  document.body.dataset.errors += 'blocked: ' + event.violatedDirective + ' ' + event.blockedURI + '\n';
});
