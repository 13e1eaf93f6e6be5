// Reads the errors of a command as objects. With the option --errors-as-json the program writes an error as its last
// line on standard error (src/isolaw/app/app.cpp).

export const asksForErrors = (argv) => ['--errors-as-json', ...argv];

// Returns the error of a command or null. `lines` are the lines of standard error, and the line with the error is
// removed from them. The error is {kind, complaints: [{where, found, allowed, advice, names}]}. `kind` is 'input',
// 'memory', 'system' or 'internal'. If a column was not found, `names` are the columns that exist.
export function errorIn(lines, code) {
  if (code === 0 || lines.length === 0) return null;
  try {
    const { error = null } = JSON.parse(lines.at(-1)) ?? {};
    if (error) lines.pop();
    return error;
  } catch {
    return null; // the last line is a message and not JSON
  }
}
