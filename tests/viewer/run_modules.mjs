// Properties of the modules of the page of a run that need no browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { creasedCorners } from '../../viewer/src/gl/creases.js';
import { framedPoints } from '../../viewer/src/run/frame.js';
import { handLines, planSummary, shareColor } from '../../viewer/src/run/plan.js';
import { counterpartOf, decodeRecording, placed } from '../../viewer/src/run/recording.js';
import { createPlayerState } from '../../viewer/src/run/state.js';
import { lastNotAfter, poseAt, slerp } from '../../viewer/src/run/track.js';
import { clock, progress, summary } from '../../viewer/src/run/words.js';
import { randomNumbers } from './fixture.mjs';
import { recordedRun } from './run_fixture.mjs';
import { box, capsule } from './run_meshes.mjs';

const close = (a, b, tolerance) => a.forEach((value, i) => assert.ok(Math.abs(value - b[i]) <= tolerance, `${a} is not ${b}`));

function randomRotation(random) {
  const q = Array.from({ length: 4 }, () => random() - 0.5);
  const size = Math.hypot(...q);
  return q.map((value) => value / size);
}

test('interpolated rotations are unit, begin and end at theirs, and turn evenly the shorter way', () => {
  const random = randomNumbers(11);
  const angle = (a, b) => 2 * Math.acos(Math.min(1, Math.abs(a.reduce((sum, value, i) => sum + value * b[i], 0))));
  for (let round = 0; round < 200; ++round) {
    const [a, b] = [randomRotation(random), randomRotation(random)];
    const [t, whole] = [random(), angle(a, b)];
    const middle = slerp(a, b, t);
    assert.ok(Math.abs(Math.hypot(...middle) - 1) < 1e-9);
    assert.ok(Math.abs(angle(a, middle) - t * whole) < 1e-6);
    assert.ok(Math.abs(angle(middle, b) - (1 - t) * whole) < 1e-6);
  }
});

test('a pose at a recorded time is the recorded one, before and after the run the nearest', () => {
  const track = { times: [1, 2, 2, 4], positions: Float32Array.from([0, 0, 0, 1, 0, 0, 5, 0, 0, 5, 2, 0]), rotations: Float32Array.from([0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0]) };
  close(poseAt(track, 0).position, [0, 0, 0], 0);
  close(poseAt(track, 1.5).position, [0.5, 0, 0], 1e-7);
  close(poseAt(track, 2).position, [5, 0, 0], 0);
  close(poseAt(track, 3).position, [5, 1, 0], 1e-7);
  close(poseAt(track, 9).position, [5, 2, 0], 0);
  close(poseAt(track, 1.5).rotation, [0, 0, Math.SQRT1_2, Math.SQRT1_2], 1e-6);
});

test('the last time not after another is that of a linear search', () => {
  const random = randomNumbers(2);
  for (let round = 0; round < 100; ++round) {
    const times = Array.from({ length: Math.floor(8 * random()) }, () => Math.floor(6 * random())).sort();
    const time = Math.floor(8 * random()) - 1;
    assert.equal(lastNotAfter(times, time), times.findLastIndex((each) => each <= time));
  }
});

test('a turned point keeps its distance from the origin of the solid', () => {
  const random = randomNumbers(5);
  for (let round = 0; round < 50; ++round) {
    const [p, position] = [0, 1].map(() => [random(), random(), random()]);
    const moved = placed({ position, rotation: randomRotation(random) }, p);
    assert.ok(Math.abs(Math.hypot(...moved.map((value, k) => value - position[k])) - Math.hypot(...p)) < 1e-9);
  }
  close(placed({ position: [0, 0, 1], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] }, [1, 0, 0]), [0, 1, 1], 1e-12);
});

test('a believed object belongs to the nearest true one, and to none far from all', () => {
  const run = decodeRecording(recordedRun());
  const believed = run.believed(0);
  assert.deepEqual(believed.map(({ counterpart }) => counterpart?.name ?? null), ['cereal', 'can', 'sugar', 'tuna', 'brick', 'crate', null]);
  assert.equal(counterpartOf(null, run.objects, 0), null);
  const [cereal] = believed;
  assert.equal(counterpartOf(cereal.extent, run.objects, run.end)?.name, undefined, 'it was carried away');
});

test('a view frames objects, bin and hand, but not a robot that is far larger than they', () => {
  const run = decodeRecording(recordedRun());
  const highest = (solids) => Math.max(...framedPoints({ ...run, solids }).map(([, , z]) => z));
  const tower = { kind: 'robot', extent: { low: [-0.1, -0.1, 0], high: [0.1, 0.1, 5], middle: [0, 0, 2.5], diagonal: 5 }, track: run.solids[0].track };
  assert.ok(highest(run.solids) > 0.4, 'the arm is in view');
  assert.equal(highest([...run.solids, tower]), highest(run.solids));
  assert.equal(highest([tower]), 5, 'a robot alone is framed');
  assert.deepEqual(framedPoints({ ...run, solids: [] }), []);
});

test('edges of a box stay sharp, and a capsule is smooth', () => {
  const flat = ({ positions, triangles }) => ({ positions: Float32Array.from(positions.flat()), triangles: Uint32Array.from(triangles.flat()) });
  const { normals } = creasedCorners(flat(box([0.1, 0.2, 0.3])));
  for (let i = 0; i < normals.length; i += 3) close([...normals.subarray(i, i + 3)].map(Math.abs).sort(), [0, 0, 1], 1e-6);
  const round = creasedCorners(flat(capsule(0.1, 0.4)));
  const byPlace = new Map();
  for (let i = 0; i < round.corners.length; i += 3) {
    const key = [...round.corners.subarray(i, i + 3)].map((value) => value.toFixed(5)).join();
    const normal = [...round.normals.subarray(i, i + 3)];
    if (byPlace.has(key) && Math.abs(round.corners[i + 2] - 0.2) < 0.29) close(normal, byPlace.get(key), 1e-4);
    byPlace.set(key, normal);
  }
});

test('the player stays within the run, stops at its end, and steps through the events', () => {
  const { store, actions, currentEvent } = createPlayerState({ begin: 2, end: 10, events: [{ time: 1 }, { time: 4 }, { time: 4 }, { time: 12 }] });
  actions.seek(-3);
  assert.equal(store.get().time, 2);
  actions.seek(Number.NaN);
  assert.equal(store.get().time, 2);
  actions.nextEvent();
  assert.equal(store.get().time, 4);
  assert.equal(currentEvent(4), 2);
  actions.nextEvent();
  assert.equal(store.get().time, 10, 'an event after the last moment is there');
  actions.previousEvent();
  assert.equal(store.get().time, 4);
  actions.setSpeed(8);
  actions.play();
  actions.advance(0.5);
  assert.deepEqual([store.get().time, store.get().playing], [8, true]);
  actions.advance(0.5);
  assert.deepEqual([store.get().time, store.get().playing], [10, false]);
  actions.play();
  assert.equal(store.get().time, 2);
  actions.setSpeed(3);
  assert.equal(store.get().speed, 8);
});

test('picked are all objects but those that were left, and no more than there are successes', () => {
  const events = [1, 2, 3, 4].map((time) => ({ time, outcome: time === 2 ? 'failure' : 'success' }));
  const run = { objects: [1, 2, 3], left: ['one'], events, begin: 0, end: 4 };
  assert.equal(summary(run), 'Picked 2 of 3 objects in 4.0 s · 1 failure');
  assert.deepEqual([0, 1, 2, 3, 4].map((time) => progress(run, time)[0]), ['0', '1', '1', '2', '2'], 'the end of the run is a success too');
});

test('clocks count minutes and tenths', () => {
  assert.deepEqual([0, 9.96, 59.96, 83.41, 600, -1.25].map(clock), ['0:00.0', '0:10.0', '1:00.0', '1:23.4', '10:00.0', '−0:01.3']);
});

test('colours of shares get darker, and shares outside 0 to 1 have those of the ends', () => {
  const lightness = Array.from({ length: 101 }, (_, i) => shareColor(i / 100).reduce((sum, value) => sum + value, 0));
  lightness.slice(1).forEach((value, i) => assert.ok(value <= lightness[i], `${i} %`));
  assert.deepEqual([shareColor(-1), shareColor(2)], [shareColor(0), shareColor(1)]);
});

test('the drawn fingers are as far apart as the grasp is open, and end at the tips', () => {
  const lines = handLines({ position: [1, 2, 3], closing: [0, 1, 0], approach: [0, 0, -1], opening: 0.06 }, 0.05);
  assert.equal(lines.length % 2, 0);
  close(lines[1], [1, 2.03, 2.95], 1e-12);
  close(lines[3], [1, 1.97, 2.95], 1e-12);
});

test('the summary of a plan counts each grasp once', () => {
  const grasps = ['not_reached', 'chosen', 'not_tried', 'reached', 'not_reached'].map((state) => ({ state }));
  assert.equal(planSummary({ grasps }), '2 of 5 grasps reached · 2 not reached · 1 not tried');
  assert.equal(planSummary({ grasps: [] }), '0 of 0 grasps reached');
});
