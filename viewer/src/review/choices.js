// What a person chose: for each symmetry of each model accepted (true), rejected (false) or open (null).

import { cross, dot, isVector, length, normalize, reject, subtract } from '../vector.js';

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
      models.forEach(({ name, diagonal, symmetries }, m) => {
        const other = file.models.find((model) => model.name === name)?.symmetries ?? [];
        symmetries.forEach((symmetry, s) => {
          const choice = other.find((each) => isSame(each, symmetry, diagonal))?.choice;
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

// As the command matches choices with symmetries: of one kind and order, within 1° and 1 % of the diagonal.
const SAME_SINE = Math.sin(Math.PI / 180);
const SAME_DISTANCE = 0.01;

function isSame(saved, found, diagonal) {
  if (saved.kind !== found.kind) return false;
  if (found.kind === 'sphere') return true;
  if (found.kind === 'axis' && (saved.order ?? found.order) !== found.order) return false;
  if (!isVector(saved.point) || !isVector(saved.direction)) return false;
  if (length(cross(normalize(saved.direction), found.direction)) > SAME_SINE) return false;
  const apart = subtract(saved.point, found.point);
  const distance = found.kind === 'plane' ? Math.abs(dot(found.direction, apart)) : length(reject(apart, found.direction));
  return distance <= SAME_DISTANCE * diagonal;
}
