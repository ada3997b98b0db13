// The data of the timeline to lanes of slices: what ran when, and when it was kept from running.

/** Calls `take` for each `count` numbers of a flat list. */
function each(list, count, take) {
  for (let i = 0; i + count <= list.length; i += count) take(...list.slice(i, i + count));
}

/** Sorted, with what touches or overlaps made one. */
function union(intervals) {
  const all = [];
  for (const [begin, end] of [...intervals].sort((a, b) => a[0] - b[0])) {
    const last = all[all.length - 1];
    if (last && begin <= last[1]) last[1] = Math.max(last[1], end);
    else if (end > begin) all.push([begin, end]);
  }
  return all;
}

/** What is left of [begin, end] without the intervals of a union. */
function without(begin, end, taken) {
  const pieces = [];
  let low = 0;
  let high = taken.length;
  while (low < high) {  // the first that ends behind `begin`
    const middle = (low + high) >> 1;
    if (taken[middle][1] <= begin) low = middle + 1;
    else high = middle;
  }
  let at = begin;
  for (let i = low; i < taken.length && taken[i][0] < end; ++i) {
    if (taken[i][0] > at) pieces.push([at, taken[i][0]]);
    at = Math.max(at, taken[i][1]);
  }
  if (at < end) pieces.push([at, end]);
  return pieces;
}

/** How long a slice waits while something more urgent runs. */
function waitOf(slice) {
  const ran = (slice.pieces ?? [[slice.begin, slice.end]]).reduce((sum, [begin, end]) => sum + end - begin, 0);
  return slice.end - slice.begin - ran;
}

/**
 * Lanes from top to bottom: buses, interrupts, buckets from the shortest period on. A slice has `begin`, `end`, `name`,
 * `kind` (update, handle, flush, entry, interrupt, frame), `row` (0 or 1 of its lane), `device` (-1: none), and of
 * stages the `pieces` in which it ran; of frames that were asked for the devices `carried`.
 */
function readLanes() {
  const buses = data.buses.map((name, i) => ({title: name, about: 'frames', colour: `--bus-${i % 8}`, rows: 1, kind: 'bus', slices: []}));
  each(data.frames, 5, (bus, flags, device, begin, length) => {
    const isReceived = flags & 1;
    const lane = buses[bus];
    if (isReceived) {
      lane.rows = 2;
      lane.about = 'frames sent, and received below';
    }
    const carried = device < 0 ? data.flushes[-1 - device] : [device];
    lane.slices.push({kind: 'frame', row: isReceived, device, begin, end: begin + length, pieces: null,
                      carried: flags & 2 ? carried : [],
                      name: device < 0 ? carried.map((one) => data.devices[one]).join(', ') : data.devices[device]});
  });
  const interrupts = {title: 'interrupts', about: '', colour: '--muted', rows: 1, kind: 'interrupt', slices: []};
  each(data.interrupts, 3, (stream, begin, length) => interrupts.slices.push(
      {kind: 'interrupt', row: 0, device: -1, begin, end: begin + length, name: data.streams[stream], pieces: null}));
  const buckets = data.buckets.map((bucket, i) => ({title: `every ${bucket.name}`, about: 'update() above, handle() below',
      colour: `--period-${i % 6}`, rows: 2, kind: 'bucket', slices: []}));
  addStages(buckets, union(interrupts.slices.map((slice) => [slice.begin, slice.end])));
  const lanes = [...buses.filter((lane) => lane.slices.length > 0), interrupts, ...buckets];
  for (const lane of lanes) lane.slices.sort((a, b) => a.row - b.row || a.begin - b.begin);
  return lanes;
}

/** Stages and what is left of their jobs, with the pieces in which they ran. */
function addStages(buckets, busy) {
  const jobs = buckets.map(() => []);
  each(data.jobs, 3, (bucket, begin, length) => jobs[bucket].push([begin, begin + length]));
  const stages = buckets.map(() => []);
  let begin = 0;
  let order = 0;  // in which they ended
  each(data.stages, 4, (device, isHandle, gap, length) => {
    begin += gap;
    stages[data.bucketOf[device]].push(
        {kind: isHandle ? 'handle' : 'update', row: isHandle, device, begin, end: begin + length, name: data.devices[device],
         order: order++});
  });
  let taken = busy;
  buckets.forEach((lane, i) => {
    lane.slices = [...stages[i], ...flushesOf(jobs[i], stages[i])];
    for (const slice of lane.slices) slice.pieces = without(slice.begin, slice.end, taken);
    taken = union([...taken, ...jobs[i]]);
  });
}

/** What a job does behind its last handle. */
function flushesOf(jobs, stages) {
  const ends = stages.map((stage) => stage.end).sort((a, b) => a - b);
  const flushes = [];
  for (const [begin, end] of jobs) {
    let low = 0;
    let high = ends.length;
    while (low < high) {  // the first end behind the job's
      const middle = (low + high) >> 1;
      if (ends[middle] <= end) low = middle + 1;
      else high = middle;
    }
    const last = low > 0 ? ends[low - 1] : begin;
    if (last >= begin && last < end) flushes.push({kind: 'flush', row: 1, device: -1, begin: last, end, name: 'flush and exit'});
  }
  return flushes;
}
