// What a person chose: for each symmetry of each model accepted (true), rejected (false) or open (null).

const VERSION = 1;
const ACCEPTED = 'accepted';
const REJECTED = 'rejected';
const wordOf = (value) => (value === null ? 'open' : value ? ACCEPTED : REJECTED);

export function createChoices(models) {
  const chosen = models.map(({ symmetries }) => symmetries.map(() => null));
  const listeners = [];
  const total = chosen.flat().length;
  let saved = true;

  const choices = {
    total,
    get: (model, symmetry) => chosen[model][symmetry],
    set(model, symmetry, value) {
      chosen[model][symmetry] = value;
      saved = false;
      for (const listener of listeners) listener();
    },
    subscribe: (listener) => listeners.push(listener),
    decided: (model) => chosen[model].filter((value) => value !== null).length,
    decidedOfAll: () => chosen.flat().filter((value) => value !== null).length,
    isSaved: () => saved,
    markSaved() { saved = true; },
    toJson: () => ({
      version: VERSION,
      models: models.map(({ name, symmetries }, m) => ({
        name,
        symmetries: symmetries.map(({ kind, order, point, direction }, s) => ({
          kind, ...(order === null ? {} : { order }), point, direction, choice: wordOf(chosen[m][s]),
        })),
      })),
    }),
    /** Takes the choices of a file for symmetries that are the same; returns how many. */
    load(file) {
      if (file?.version !== VERSION || !Array.isArray(file.models)) throw new Error('This is no file of choices.');
      let taken = 0;
      models.forEach(({ name, symmetries }, m) => {
        const other = file.models.find((model) => model.name === name)?.symmetries ?? [];
        symmetries.forEach((symmetry, s) => {
          const choice = other.find((each) => isSame(each, symmetry))?.choice;
          if (choice !== ACCEPTED && choice !== REJECTED) return;
          chosen[m][s] = choice === ACCEPTED;
          taken += 1;
        });
      });
      if (taken > 0) saved = false;
      for (const listener of listeners) listener();
      return taken;
    },
  };
  return choices;
}

// The page and the file hold the same numbers if they are of the same models.
function isSame(a, b) {
  const near = (p, q) => p?.every((value, k) => Math.abs(value - q[k]) <= 1e-6 * (1 + Math.abs(q[k])));
  return a.kind === b.kind && (a.order ?? null) === b.order && near(a.point, b.point) && near(a.direction, b.direction);
}
