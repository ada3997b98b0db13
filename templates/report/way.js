// A chain to the slices that its oldest command came through.

/** The last slice of a list of which the first ones fit; undefined where none does. */
function lastThat(fits, slices) {
  let low = 0;
  let high = slices.length;
  while (low < high) {  // the first that does not
    const middle = (low + high) >> 1;
    if (fits(slices[middle])) low = middle + 1;
    else high = middle;
  }
  return slices[low - 1];
}

/** Of stages: those that had published when `stage` began. Some take no time: then their order counts. */
function isBefore(stage) {
  return (one) => one.end <= stage.begin && one.order < stage.order;
}

/** The slices of the lanes of one kind that `fits`, in the order of time. */
function slicesOf(lanes, kind, fits) {
  return lanes.filter((lane) => lane.kind === kind).flatMap((lane) => lane.slices.filter(fits)).sort((a, b) => a.end - b.end || a.order - b.order);
}

/**
 * Stages from the update() that read the sample to the handle() that has the command, and the frames before and behind
 * them. A stage uses what the one before it in the chain had published when it began. Empty where no command of the time
 * shown goes back to a sample in it.
 */
function wayOf(chain, lanes) {
  const steps = [...chain.up.map((device) => ['update', device]), ...chain.down.map((device) => ['handle', device])]
      .map(([kind, device]) => slicesOf(lanes, 'bucket', (s) => s.kind === kind && s.device === device));
  const age = (way) => way[way.length - 1].end - way[0].begin;
  let oldest = [];
  for (const last of steps[steps.length - 1]) {
    const way = [last];
    for (let i = steps.length - 2; i >= 0 && way[0]; --i) way.unshift(lastThat(isBefore(way[0]), steps[i]));
    if (way[0] && (oldest.length === 0 || age(way) > age(oldest))) oldest = way;
  }
  return oldest.length > 0 ? [...frameBefore(chain, lanes, oldest[0].begin), ...oldest, ...frameBehind(chain, lanes, oldest)] : [];
}

/** The frame that brought what an update at `time` reads. */
function frameBefore(chain, lanes, time) {
  const frame = lastThat((s) => s.end <= time, slicesOf(lanes, 'bus', (s) => s.device === chain.up[0]));
  return frame ? [frame] : [];
}

/** The frame that takes the command away. */
function frameBehind(chain, lanes, way) {
  const {end} = way[way.length - 1];
  const device = chain.down[chain.down.length - 1];
  const frames = slicesOf(lanes, 'bus', (s) => s.carried.includes(device) && s.begin >= end);
  return frames.slice(0, 1);
}

/** A way in words. */
function aboutWay(chain, way) {
  const stages = way.filter((slice) => slice.kind !== 'frame');
  if (stages.length === 0) return `${chain.name}: none of its commands goes back to a sample in the time shown.`;
  const age = timeText(stages[stages.length - 1].end - stages[0].begin);
  return `${chain.name}: marked is the way of its oldest command in the time shown, ${age} from the begin of update() of `
      + `${stages[0].name} to the end of handle() of ${stages[stages.length - 1].name}.`;
}
