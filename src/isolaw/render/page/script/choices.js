// The choices of a page's reader. Controls and figures follow them; a figure names the keys that change it.

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
