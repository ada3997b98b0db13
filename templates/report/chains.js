// The table of chains as bars; choosing one shows its way in the trees and in the timeline.

const kPartNames = ['acquire', 'decide', 'wire'];
const kFewChains = 8;  // shown at first

/**
 * The cells that a chain had before the change, by its name. A chain that is new takes those of the oldest chain to the same
 * device that is gone now.
 */
function readEarlier(names) {
  const earlier = new Map([...document.querySelectorAll('#earlier-table tbody tr')]
      .map((row) => [row.cells[0].textContent, [...row.cells].slice(1)]));
  const end = (name) => name.slice(name.lastIndexOf(' → '));
  const age = (cells) => valueOf(cells[3]) ?? Infinity;
  const gone = [...earlier].filter(([name]) => !names.includes(name)).sort(([, a], [, b]) => age(b) - age(a));
  return (name) => earlier.get(name) ?? gone.find(([other]) => end(other) === end(name))?.[1] ?? null;
}

/** The chains of the table, those with the longest bound first. Cells are in the order of its columns. */
function readChains() {
  const rows = [...document.querySelectorAll('#chains-table tbody tr')];
  const earlierOf = readEarlier(rows.map((row) => row.cells[0].textContent));
  const chains = rows.map((row) => {
    const cells = [...row.cells];
    const numbers = (text) => text.split(' ').filter((word) => word !== '').map(Number);
    const measured = cells.length > 7;
    return {
      row,
      name: cells[0].textContent,
      bound: cells.slice(1, 4),
      total: cells[4],
      earlier: earlierOf(cells[0].textContent),
      simulated: cells[5],
      measured: measured ? cells.slice(6, 9) : null,
      measuredTotal: measured ? cells[9] : null,
      up: numbers(row.dataset.up),
      down: numbers(row.dataset.down),
    };
  });
  const length = (chain) => valueOf(chain.total) ?? valueOf(chain.bound[1]) ?? Infinity;
  return chains.sort((a, b) => length(b) - length(a));
}

/** A part of a bar, `length` of `longest`; one without a name leaves its place empty. */
function makePart(name, length, longest, title = '') {
  const share = 100 * length / longest;
  const part = make('i', {class: `part ${name}${share < 14 ? ' short' : ''}`.trim(), style: `width:${share}%`, title});
  if (share > 5) part.textContent = name.slice(0, 1).toUpperCase();
  return part;
}

/** How long the bars of a chain are. */
function lengthsOf(chain) {
  const sum = (cells) => (cells ?? []).reduce((all, cell) => all + (valueOf(cell) ?? 0), 0);
  const simulated = (valueOf(chain.bound[0]) ?? 0) + (valueOf(chain.simulated) ?? 0);
  return [chain.bound, chain.measured, chain.earlier?.slice(0, 3)].map(sum).concat(simulated);
}

/** One bar: whose it is, its parts, and its length in words, with a letter where that is of one part alone. */
function makeBar(who, parts, letter, total) {
  const track = make('span', {class: 'track', 'aria-hidden': 'true'}, ...parts);
  const shown = make('span', {class: 'total'}, ...(valueOf(total) !== null ? [letter, copyOf(total)] : ['no bound']));
  return make('div', {class: who === 'bound' ? 'bar' : 'bar seen'}, make('span', {class: 'who'}, who), track, shown);
}

/** The bars of a chain: its bound, and what was seen of it. */
function makeBars(chain, longest) {
  const partsOf = (cells) => cells.map((cell, i) =>
      makePart(kPartNames[i], valueOf(cell) ?? 0, longest, `${kPartNames[i]} ${cell.textContent}`));
  // Where a part has no value there is no whole either: the decision stands for it.
  const whole = (total, cells) => valueOf(total) !== null ? ['', total] : ['D ', cells[1]];
  const bars = [makeBar('bound', partsOf(chain.bound), ...whole(chain.total, chain.bound))];
  if (chain.earlier) {
    const parts = chain.earlier.slice(0, 3);
    bars.push(makeBar('before', partsOf(parts), ...whole(chain.earlier[3], parts)));
  }
  if (valueOf(chain.simulated) !== null) {
    const ahead = makePart('', valueOf(chain.bound[0]) ?? 0, longest);
    const decide = makePart('decide', valueOf(chain.simulated), longest, `decide ${chain.simulated.textContent}`);
    bars.push(makeBar('simulated', [ahead, decide], 'D ', chain.simulated));
  }
  if (chain.measured && valueOf(chain.measured[1]) !== null)
    bars.push(makeBar('measured', partsOf(chain.measured), ...whole(chain.measuredTotal, chain.measured)));
  return bars;
}

function makeChain(chain, longest) {
  const button = make('button', {type: 'button', 'aria-pressed': 'false'}, chain.name);
  button.addEventListener('click', () => selection.select(selection.chain === chain ? null : chain));
  selection.listeners.push((chosen) => button.setAttribute('aria-pressed', String(chosen === chain)));
  return make('div', {class: 'chain'}, button, make('div', {}, ...makeBars(chain, longest)));
}

/** The time axis of all bars, from 0 to `longest`. */
function makeAxis(longest) {
  const least = longest / 5;
  let step = 10 ** Math.floor(Math.log10(least));
  step *= [1, 2, 5, 10].find((factor) => step * factor >= least);
  const ticks = [];
  for (let i = 0; i * step <= longest * 0.98; ++i)
    ticks.push(make('i', {class: i % 2 ? 'between' : '', style: `left:${100 * i * step / longest}%`}, i ? timeText(i * step) : '0'));
  const axis = make('span', {class: 'axis', 'aria-hidden': 'true'}, ...ticks);
  return make('div', {class: 'chain scale'}, make('span'), make('div', {class: 'bar'}, make('span'), axis));
}

function prepareChains() {
  const chains = readChains();
  const box = find('#chain-bars');
  const longest = Math.max(1, ...chains.flatMap(lengthsOf));
  const add = (some) => box.append(...some.map((chain) => makeChain(chain, longest)));
  if (chains.length > 0) box.before(makeAxis(longest));
  add(chains.slice(0, kFewChains));
  if (chains.length > kFewChains) {
    const more = make('button', {type: 'button', class: 'more'}, `Show all ${chains.length} chains`);
    more.addEventListener('click', () => {
      more.remove();
      add(chains.slice(kFewChains));
    });
    box.after(more);
    addEventListener('beforeprint', () => more.isConnected && chains.length < 100 && more.click());
  }
  if (chains.length === 0) box.append(make('p', {class: 'note'}, 'No device takes a command.'));
}

/** Marks the devices that changed in the picture of the trees, and shows the way of the chosen chain there. */
function prepareForest() {
  const cards = [...document.querySelectorAll('.forest .device')];
  const changed = new Set([...document.querySelectorAll('#changes-table tbody th')].map((cell) => cell.textContent));
  for (const card of cards) {
    if (!changed.has(`device ${card.dataset.device}`)) continue;
    card.classList.add('changed');
    card.append(draw('title', {}, 'changed'));
  }
  const place = new Map(data.devices.map((name, i) => [name, i]));
  selection.listeners.push((chain) => {
    for (const card of cards) {
      const device = place.get(card.dataset.device);
      const isOn = chain !== null && (chain.up.includes(device) || chain.down.includes(device));
      card.classList.toggle('path', isOn);
      card.classList.toggle('off', chain !== null && !isOn);
    }
  });
}
