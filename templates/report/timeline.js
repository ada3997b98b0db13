// Lanes of slices to a picture that can be zoomed, moved and asked.

const kRow = 22;          // height of a row of slices, in pixels
const kTitle = 20;        // of the line above a lane
const kAxis = 24;
const kPaper = 720;       // width of the picture on paper
const kGap = 8;
const kThinnest = 0.6;    // slices thinner than that are drawn together
const kLetter = 6.4;      // width of a letter in a slice, about
const kFewLetters = 6;    // of a name that does not fit, where so many do
const kManyPeriods = 10;  // what is longer than that is shown from near at first

class Timeline {
  constructor(box) {
    this.lanes = readLanes();
    this.from = 0;
    this.to = this.first();
    this.picked = null;  // {lane, slice}
    this.way = null;     // slices that the oldest command of the chosen chain came through
    this.whenDrawn = null;
    this.paper = 0;      // width on paper; 0: on a screen
    this.output = make('output', {'aria-live': 'polite'});
    this.svg = draw('svg', {tabindex: '0', role: 'application', 'aria-label':
        'Timeline. Plus and minus zoom, left and right move, up and down choose a stage, 0 shows all.'});
    this.detail = make('div', {id: 'detail', 'aria-live': 'polite'});
    this.told = make('p', {id: 'way', class: 'note', 'aria-live': 'polite'});
    box.append(this.makeTools(), this.told, this.svg, this.detail);
    this.explain();
    this.listen();
    selection.listeners.push((chain) => this.follow(chain));
    this.draw();
  }

  /** How much is shown at first: one hyperperiod, or what of it can be told apart. */
  first() {
    const longest = Math.max(...data.buckets.map((bucket) => bucket.period));
    const whole = Math.min(data.hyperperiod ?? data.length, data.length);
    return whole > kManyPeriods * longest ? 2 * longest : whole;
  }

  makeTools() {
    const button = (text, label, act) => {
      const made = make('button', {type: 'button', 'aria-label': label, title: label}, text);
      made.addEventListener('click', act);
      return made;
    };
    return make('div', {class: 'tools'},
        button('+', 'Zoom in', () => this.zoom(0.5)),
        button('−', 'Zoom out', () => this.zoom(2)),
        button('◀', 'Earlier', () => this.move(-0.25)),
        button('▶', 'Later', () => this.move(0.25)),
        button('All', 'Show all', () => this.show(0, data.length)),
        this.output);
  }

  show(from, to) {
    const least = Math.min(200, data.length);
    const length = Math.min(data.length, Math.max(least, to - from));
    this.from = Math.min(Math.max(0, from), data.length - length);
    this.to = this.from + length;
    this.draw();
  }

  /** Makes what is shown `factor` times as long; the time at `share` of the width stays where it is. */
  zoom(factor, share = 0.5) {
    const length = this.to - this.from;
    const at = this.from + share * length;
    this.show(at - share * length * factor, at + (1 - share) * length * factor);
  }

  move(share) {
    const length = this.to - this.from;
    this.show(this.from + share * length, this.to + share * length);
  }

  x(time) {
    return (time - this.from) / (this.to - this.from) * this.width;
  }

  draw() {
    this.width = Math.max(200, this.paper || this.svg.clientWidth || this.svg.parentElement.clientWidth);
    const parts = [];
    let y = kAxis;
    for (const lane of this.lanes) {
      lane.top = y + kTitle;
      const height = lane.rows * kRow;
      parts.push(draw('rect', {class: 'lane', x: 0, y: lane.top, width: this.width, height}));
      y = lane.top + height + kGap;
    }
    const ticks = this.ticks(y);
    for (const lane of this.lanes) {
      const title = draw('text', {class: 'lane-title', x: 8, y: lane.top - 6});
      title.append(draw('tspan', {class: 'lane-name'}, lane.title), draw('tspan', {dx: 8}, lane.about));
      ticks.push(...this.slices(lane), title);
    }
    this.svg.replaceChildren(...parts, ...ticks, ...this.mark());
    this.svg.setAttribute('height', y);
    this.svg.setAttribute('viewBox', `0 0 ${this.width} ${y}`);
    this.svg.dataset.from = this.from;
    this.svg.dataset.to = this.to;
    this.whenDrawn?.();
    this.output.textContent = `${timeText(this.from)} to ${timeText(this.to)}`;
  }

  drawFor(paper) {
    this.paper = paper;
    this.draw();
  }

  ticks(bottom) {
    const most = Math.max(2, Math.floor(this.width / 90));
    const least = (this.to - this.from) / most;
    let step = 10 ** Math.floor(Math.log10(least));
    step *= [1, 2, 5, 10].find((factor) => step * factor >= least);
    const parts = [];
    for (let time = Math.ceil(this.from / step) * step; time <= this.to; time += step) {
      const x = this.x(time);
      parts.push(draw('line', {class: 'tick', x1: x, x2: x, y1: kAxis - 6, y2: bottom}));
      if (x < this.width - 50) parts.push(draw('text', {x: x + 4, y: 14}, timeText(time)));
    }
    return parts;
  }

  /** The slices of a lane that are in view; thin ones that follow one another as one. */
  slices(lane) {
    const parts = [];
    let thin = null;
    const flush = () => {
      if (thin) parts.push(draw('rect', {class: thin.look, x: thin.x, y: thin.y, width: Math.max(1, thin.end - thin.x), height: kRow - 4, style: thin.fill}));
      thin = null;
    };
    for (const slice of lane.slices) {
      if (slice.end < this.from || slice.begin > this.to) continue;
      const x = this.x(slice.begin);
      const end = this.x(slice.end);
      const y = lane.top + slice.row * kRow + 2;
      const [look, fill] = this.look(lane, slice);
      if (end - x >= kThinnest * 4) {
        flush();
        parts.push(...this.slice(slice, x, end, y, look, fill));
      } else if (thin && thin.y === y && thin.look === look && x - thin.end < 1) {
        thin.end = end;
      } else {
        flush();
        thin = {x, end, y, look, fill};
      }
    }
    flush();
    return parts;
  }

  /** Class and colour of a slice. */
  look(lane, slice) {
    const fill = slice.kind === 'flush' ? 'fill:var(--edge)' : `fill:var(${lane.colour})`;
    return [`${slice.kind}${this.way ? (this.way.has(slice) ? ' path' : ' off') : ''}`, fill];
  }

  slice(slice, x, end, y, look, fill) {
    const height = kRow - 4;
    const parts = [];
    const box = (from, to, extra, style) =>
        draw('rect', {class: `${look} ${extra}`.trim(), x: from, y, width: Math.max(0.5, to - from), height, rx: 2, style});
    let widest = [x, end];
    if (slice.pieces && slice.pieces.length > 0) {
      if (slice.pieces.length > 1 || slice.pieces[0][1] - slice.pieces[0][0] < slice.end - slice.begin)
        parts.push(...without(slice.begin, slice.end, slice.pieces).map(([begin, stop]) =>
            box(this.x(begin), this.x(stop), 'outline', 'fill:url(#hatch)')), box(x, end, 'outline', 'fill:none'));
      const ran = slice.pieces.map(([begin, stop]) => [this.x(begin), this.x(stop)]);
      for (const [from, to] of ran) parts.push(box(from, to, 'ran', fill));
      widest = ran.reduce((best, one) => one[1] - one[0] > best[1] - best[0] ? one : best);
    } else {
      parts.push(box(x, end, '', fill));
    }
    const from = Math.max(widest[0], 0);
    const room = Math.min(widest[1], this.width) - from - 6;
    const letters = Math.floor(room / kLetter);
    const name = letters >= slice.name.length ? slice.name : letters >= kFewLetters ? `${slice.name.slice(0, letters - 1)}…` : '';
    const isOnPale = slice.kind === 'frame' || look.endsWith(' off');
    if (name !== '') parts.push(draw('text', {class: isOnPale ? 'in-frame' : 'in', x: from + 4, y: y + 13}, name));
    return parts;
  }

  /** The pattern of what waits, and the frame around the slice that was chosen. */
  mark() {
    const pattern = draw('pattern', {id: 'hatch', width: 6, height: 6, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)'},
        draw('rect', {width: 6, height: 6, style: 'fill:var(--page)'}), draw('line', {x1: 0, x2: 0, y1: 0, y2: 6, style: 'stroke:var(--edge);stroke-width:3'}));
    const parts = [draw('defs', {}, pattern)];
    if (this.picked) {
      const {lane, slice} = this.picked;
      const x = this.x(slice.begin);
      parts.push(draw('rect', {class: 'picked', x: x - 1, y: lane.top + slice.row * kRow + 1, rx: 3,
                               width: Math.max(3, this.x(slice.end) - x + 2), height: kRow - 2}));
    }
    return parts;
  }

  /** The slice under a point of the picture. */
  at(x, y) {
    const time = this.from + x / this.width * (this.to - this.from);
    const slack = 3 / this.width * (this.to - this.from);
    for (const lane of this.lanes) {
      if (y < lane.top || y >= lane.top + lane.rows * kRow) continue;
      const row = Math.floor((y - lane.top) / kRow);
      const near = lane.slices.filter((s) => s.row === row && s.begin - slack <= time && time <= s.end + slack);
      const slice = near.find((s) => s.begin <= time && time <= s.end) ?? near[0];
      if (slice) return {lane, slice};
    }
    return null;
  }

  pick(picked) {
    if (picked?.slice === this.picked?.slice) return;
    this.picked = picked;
    this.explain();
    this.draw();
  }

  /** The next stage in time, or the one before. */
  step(way) {
    const stages = this.lanes.filter((lane) => lane.kind === 'bucket')
        .flatMap((lane) => lane.slices.map((slice) => ({lane, slice}))).sort((a, b) => a.slice.begin - b.slice.begin);
    if (stages.length === 0) return;
    const here = stages.findIndex((one) => one.slice === this.picked?.slice);
    const first = Math.max(0, stages.findIndex((one) => one.slice.begin >= this.from));
    const next = here < 0 ? stages[first] : stages[(here + way + stages.length) % stages.length];
    this.pick(next);
    const length = this.to - this.from;
    if (next.slice.begin < this.from || next.slice.end > this.to) this.show(next.slice.begin - length / 4, next.slice.begin + 3 * length / 4);
  }

  /** What is known of the chosen slice, with the results of its device. */
  explain() {
    if (!this.picked) {
      this.detail.replaceChildren(make('span', {class: 'note'},
          'Point at a stage, an interrupt or a frame; or focus the timeline and use the arrow keys.'));
      return;
    }
    const {slice} = this.picked;
    const list = make('dl');
    const add = (name, value) => list.append(make('div', {}, make('dt', {}, name), value));
    add('from', make('dd', {}, timeText(slice.begin)));
    add('for', make('dd', {}, timeText(slice.end - slice.begin)));
    if (slice.pieces) add('of that waiting', make('dd', {}, timeText(waitOf(slice))));
    const row = slice.device >= 0 ? find(`#devices-table tr[data-device="${slice.device}"]`) : null;
    if (row) {
      const cells = [...row.cells];
      if (slice.kind === 'update' || slice.kind === 'handle')
        add('own time, longest', copyOf(cells[slice.kind === 'update' ? 4 : 5], 'dd'));
      add('response, bound', copyOf(cells[7], 'dd'));
      add('worst simulated', copyOf(cells[8], 'dd'));
      if (cells.length > 9) add('worst measured', copyOf(cells[9], 'dd'));
    }
    this.detail.replaceChildren(make('b', {}, `${slice.name} ${kStageWords[slice.kind]}`.trim()), list);
  }

  /** Shows the stages that the oldest command of a chosen chain came through. */
  follow(chain) {
    const way = chain ? wayOf(chain, this.lanes) : [];
    this.way = chain ? new Set(way) : null;
    this.told.textContent = chain ? aboutWay(chain, way) : '';
    if (way.length === 0) return this.draw();
    const begin = way[0].begin;
    const end = way[way.length - 1].end;
    const margin = 0.1 * (end - begin);
    this.show(begin - margin, end + margin);
  }

  listen() {
    const keys = {
      '+': () => this.zoom(0.5), '=': () => this.zoom(0.5), '-': () => this.zoom(2), '0': () => this.show(0, data.length),
      ArrowLeft: () => this.move(-0.1), ArrowRight: () => this.move(0.1), Home: () => this.show(0, this.to - this.from),
      End: () => this.show(data.length - (this.to - this.from), data.length),
      ArrowDown: () => this.step(1), ArrowUp: () => this.step(-1), Escape: () => this.pick(null),
    };
    this.svg.addEventListener('keydown', (event) => {
      if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      keys[event.key]();
    });
    this.svg.addEventListener('wheel', (event) => {
      if (!event.ctrlKey) return;  // the page scrolls
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 0.8 : 1.25, event.offsetX / this.width);
    }, {passive: false});
    let drag = null;
    this.svg.addEventListener('pointerdown', (event) => {
      drag = {x: event.offsetX, from: this.from, to: this.to};
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener('pointerup', () => drag = null);
    this.svg.addEventListener('pointercancel', () => drag = null);
    this.svg.addEventListener('pointermove', (event) => {
      if (!drag) return this.pick(this.at(event.offsetX, event.offsetY) ?? this.picked);
      const shift = (drag.x - event.offsetX) / this.width * (drag.to - drag.from);
      this.show(drag.from + shift, drag.to + shift);
    });
    this.svg.addEventListener('pointerdown', (event) => this.pick(this.at(event.offsetX, event.offsetY) ?? this.picked));
    new ResizeObserver(() => this.svg.clientWidth !== this.width && this.draw()).observe(this.svg);
    addEventListener('beforeprint', () => this.drawFor(kPaper));
    addEventListener('afterprint', () => this.drawFor(0));
  }
}
