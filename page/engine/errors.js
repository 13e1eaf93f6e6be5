// Failures of a command as objects: the program writes one as its last line to standard error where it is asked to
// (src/isolaw/app/app.cpp).

export const asksForErrors = (argv) => ['--errors-as-json', ...argv];

// {kind, complaints: [{where, found, allowed, advice, names}]}, or null. Takes its line out of `lines`, those of standard
// error. `kind`: 'input', 'memory', 'system', 'internal'; `names`: columns that are there, where one was not found.
export function errorIn(lines, code) {
  if (code === 0 || lines.length === 0) return null;
  try {
    const { error = null } = JSON.parse(lines.at(-1)) ?? {};
    if (error) lines.pop();
    return error;
  } catch {
    return null; // the command ended with a refusal and no error: its last line is a message
  }
}
