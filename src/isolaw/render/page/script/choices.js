// The reader's choices on a page. Controls and figures follow them; each figure names the choices that change it.

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
