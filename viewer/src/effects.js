// What decided a score, in words.
import * as format from './format.js';

const FEATURES = {
  broken: 'surface goes on across its border', torn: 'border is not along creases', rim: 'points at a border to other surface',
  bend: 'concave bends inside', crease: 'creases inside', seam: 'a seam divides it', fold: 'a fold divides it',
  fold_rim: 'folds away from its surroundings', unity: 'in one piece', near_unity: 'in one piece, small gaps bridged',
  convexity: 'convex', empty: 'seen empty space between its points', width_ratio: 'width beside length',
  thickness_ratio: 'thickness beside length', near_others: 'points beside other things', axes: 'axes of its hypotheses',
  axis_misfit: 'misfit of its best axis', axis_occlusion: 'image about its axis lies in empty space', planes: 'mirror planes of its hypotheses',
  plane_inlier: 'points that its best plane mirrors onto others', plane_occlusion: 'mirror image lies in empty space',
  continued: 'another hypothesis continues it', joined: 'its parts continue each other', confidence: 'confidence of its best hypothesis',
  whole: 'score of a larger hypothesis that holds it', whole_share: 'share of that larger hypothesis', part: 'score of a part of it',
  rival: 'score of an overlapping hypothesis', rest: 'score of the rest of the larger hypothesis', split: 'score of two parts that split it',
  covered: 'covered by likely parts', covered_score: 'covered by likely parts, by score', pieces: 'likely parts in it',
  wholes: 'larger hypotheses that hold it', parts: 'smaller hypotheses in it',
};

export const featureText = (name) => FEATURES[name] ?? format.words(name).toLowerCase();

/** The effects for and against an object, each strongest first. */
export function sides(effects) {
  return {
    raising: effects.filter(({ effect }) => effect > 0).sort((a, b) => b.effect - a.effect),
    lowering: effects.filter(({ effect }) => effect < 0).sort((a, b) => a.effect - b.effect),
  };
}

const number = (value) => format.fixed(value, Number.isInteger(value) ? 0 : 2);

/** "0.98, usually 0.61": the value, and its median over the hypotheses of the scene. */
export const valueText = ({ value, median }) => `${number(value)}, usually ${number(median)}`;
