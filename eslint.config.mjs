// Rules of ESLint for the page's script and its tests. The build checks what modules import and export
// (cmake/join_modules.cmake).
import js from '@eslint/js';

const names = (text) => Object.fromEntries(text.split(' ').map((name) => [name, 'readonly']));
const browser = names(
  'Blob Event HTMLTableCellElement IntersectionObserver KeyboardEvent Plotly ResizeObserver URL URLSearchParams dispatchEvent document ' +
    'getComputedStyle getSelection history location navigator performance requestAnimationFrame scrollTo setTimeout window',
);
const pageAlone = names('addEventListener atob btoa clearInterval setInterval CompressionStream DecompressionStream AbortController Node TextDecoder TextEncoder crypto');
const node = names('Buffer console process TextEncoder clearInterval clearTimeout setInterval');
const engine = names('AbortController DecompressionStream Response WebAssembly Worker atob clearInterval self setInterval Buffer process console TextDecoder TextEncoder globalThis');
const rules = {
  ...js.configs.recommended.rules,
  'array-callback-return': 'error',
  'consistent-return': 'error',
  eqeqeq: 'error',
  'no-control-regex': 'off', // dom.js finds control characters in texts with such an expression
  'no-duplicate-imports': 'error',
  'no-unused-vars': ['error', { argsIgnorePattern: '^_$' }],
  'no-use-before-define': ['error', { functions: false, variables: false }],
  'no-var': 'error',
  'prefer-const': 'error',
};

export default [
  { files: ['src/**/*.js'], languageOptions: { globals: browser }, rules },
  { files: ['page/*.js', 'tests/page/stand_in/*.js'], languageOptions: { globals: { ...browser, ...pageAlone } }, rules },
  { files: ['page/*.mjs', 'tests/page/*.mjs'], languageOptions: { globals: { ...browser, ...node } }, rules },
  { files: ['page/engine/*', 'tests/page/engine/*.mjs'], languageOptions: { globals: { ...browser, ...engine } }, rules },
  { files: ['page/**/*.cjs'], languageOptions: { sourceType: 'script' } },
  { files: ['tests/browser/*.mjs', 'tools/*.mjs', '*.mjs'], languageOptions: { globals: { ...browser, ...node, asSet: 'readonly', reportAsShown: 'readonly' } }, rules },
];
