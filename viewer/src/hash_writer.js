// Writes the hash of the address without a new entry in the history.

/** A function that replaces the hash, given without "#". One that was just set elsewhere stays: the browser tells of it later. */
export function createHashWriter() {
  let known = location.hash; // as it was read or written last
  addEventListener('hashchange', () => { known = location.hash; });
  return (hash) => {
    if (location.hash !== '' && location.hash !== known) return;
    if (hash !== location.hash.replace(/^#/, '')) history.replaceState(null, '', hash ? `#${hash}` : location.pathname + location.search);
    known = location.hash;
  };
}
