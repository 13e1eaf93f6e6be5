// Failures of a command as objects. If asked to, the program writes one as its last line to standard error
// (src/isolaw/app/app.cpp).

export const asksForErrors = (argv) => ['--errors-as-json', ...argv];

// Returns {kind, complaints: [{where, found, allowed, advice, names}]} or null, and removes its line from `lines`, the
// lines of standard error. `kind`: 'input', 'memory', 'system', 'internal'; `names`: existing columns, if one was not
// found.
export function errorIn(lines, code) {
  if (code === 0 || lines.length === 0) return null;
  try {
    const { error = null } = JSON.parse(lines.at(-1)) ?? {};
    if (error) lines.pop();
    return error;
  } catch {
    return null; // the command refused without an error: its last line is a message
  }
}
