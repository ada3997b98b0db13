// What the timeline shows as a table, for those who do not see it.

const kMostRows = 200;
const kStageWords = {update: 'update()', handle: 'handle()', frame: 'frame', interrupt: 'interrupt', flush: ''};

/** The slices in view in the order of time, each with its lane. */
function slicesInView(view) {
  return view.lanes.flatMap((lane) => lane.slices.filter((slice) => slice.end >= view.from && slice.begin <= view.to)
      .map((slice) => ({lane, slice}))).sort((a, b) => a.slice.begin - b.slice.begin);
}

function rowOf({lane, slice}) {
  const cell = (text) => make('td', {}, text);
  return make('tr', {}, make('th', {scope: 'row'}, `${slice.name} ${kStageWords[slice.kind]}`.trim()),
      make('td', {class: 'word'}, lane.title), cell(timeText(slice.begin)), cell(timeText(slice.end)),
      cell(timeText(waitOf(slice))));
}

/** A table below the timeline that follows it while it is open. */
function prepareTimelineTable(view) {
  const head = make('tr', {}, ...['What', 'Where', 'Begin', 'End', 'Waiting in between']
      .map((title, i) => make('th', {scope: 'col', ...(i > 1 ? {class: 'number'} : {})}, title)));
  const caption = make('caption');
  const body = make('tbody');
  const details = make('details', {}, make('summary', {}, 'What is shown as a table'),
      make('div', {class: 'scroll tall', tabindex: '0', role: 'region', 'aria-label': 'The timeline as a table'},
          make('table', {id: 'timeline-table'}, caption, make('thead', {}, head), body)));
  const fill = () => {
    if (!details.open) return;
    const all = slicesInView(view);
    const whole = `What runs from ${timeText(view.from)} to ${timeText(view.to)}`;
    caption.textContent = all.length > kMostRows ? `${whole}: the first ${kMostRows} of ${all.length}; zoom in for others` : whole;
    body.replaceChildren(...all.slice(0, kMostRows).map(rowOf));
  };
  details.addEventListener('toggle', fill);
  view.whenDrawn = fill;
  find('#timeline').append(details);
}
