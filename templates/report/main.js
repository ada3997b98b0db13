// Brings the page to life. Everything that is proven or measured is there without it.
prepareTheme();
prepareForest();
prepareChains();
const view = new Timeline(find('#timeline-view'));
prepareTimelineTable(view);
