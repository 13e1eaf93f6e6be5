// What the reader of a page has chosen, and what follows it: controls that show the same, figures that depend on it.
// A figure names the keys that change it.

export function choices(first) {
  const chosen = first;
  const followers = [];
  return {
    chosen,
    onChoice: (follow) => followers.push(follow),
    choose: (changes) => {
      Object.assign(chosen, changes);
      for (const follow of followers) follow(changes);
    },
  };
}
