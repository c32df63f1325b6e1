"use strict";
// Draws plots as SVG: axes, curves, a legend, and the values of the point under the pointer. The plots of a report are
// JSON in its figures of class "plot", written by plot.cpp; plot.hpp says what their members mean. A page that makes its
// own plots calls draw_curves() or draw_axes().
const palette = ["#2f7fd1", "#e2702b", "#2e9e62", "#a05bc4", "#c8394b", "#8a7a1c", "#1b9aa8", "#7d7f87"];
const plot_width = 640;
/** The outlines of markers, as paths that begin in the middle. */
const marker_shapes = {circle: "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z", square: "m-3.5-3.5h7v7h-7z"};

/** An element with attributes and children; an attribute that is a function listens. */
function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}
function drawn(tag, attributes = {}, ...children) {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}
function filled(node, attributes, children = []) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value !== undefined && value !== null) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

/** A number with so many significant digits, or with all of them where it is whole. */
function number_text(value, digits = 4) {
  if (value === undefined || value === null) return "–";
  if (Number.isInteger(value) && Math.abs(value) < 1e7) return value.toLocaleString("en");
  const size = Math.abs(value), rounded = Number(value.toPrecision(digits));
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? rounded.toExponential() : String(rounded);
}

/** The range of an axis that holds all values with some air; a linear one begins at zero where that is asked for. */
function range_of(values, {logarithmic = false, from_zero = false, air = 0.07}) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (logarithmic && value <= 0) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) low = high = 1;
  if (logarithmic) return {low: low / 1.3, high: high * 1.3, logarithmic};
  if (from_zero) low = Math.min(low, 0);
  const size = Math.max(Math.abs(low), Math.abs(high)) || 1;
  // What differs by rounding only is the same.
  const margin = high - low > 1e-9 * size ? air * (high - low) : 0.07 * size;
  return {low: low === 0 ? 0 : low - margin, high: high + margin, logarithmic};
}

/** Round numbers within a range, with their texts: `most` at most, or 1, 2 and 5 of each power of ten, or 1 alone, if it
    is logarithmic. */
function ticks_of({low, high, logarithmic}, most) {
  const ticks = [];
  if (logarithmic) {
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
      for (const digit of high / low > 3000 ? [1] : [1, 2, 5]) {
        const value = digit * 10 ** power;
        if (value >= low * 0.999 && value <= high * 1.001) ticks.push({value, text: number_text(value)});
      }
    return ticks.length > 2 ? ticks : ticks_of({low, high}, most);
  }
  const raw = (high - low) / most;
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = unit * [1, 2, 5, 10].find((factor) => factor * unit >= raw);
  const digits = Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / step)) + 1;
  for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-9); ++k) {
    const value = Number((k * step).toPrecision(12));
    ticks.push({value, text: number_text(value, Math.max(4, digits))});
  }
  return ticks;
}

function scale_of({low, high, logarithmic}, from, to) {
  const f = logarithmic ? Math.log : (v) => v;
  return (value) => from + (to - from) * (f(value) - f(low)) / (f(high) - f(low));
}

/** Draws axes with their grid. Returns the picture, its edges, and the functions that tell where values go in it. */
function draw_axes({x_range, y_range, x_label, y_label, height}) {
  const svg = drawn("svg", {viewBox: `0 0 ${plot_width} ${height}`, role: "img", "aria-label": `${y_label} over ${x_label}`});
  const x_ticks = ticks_of(x_range, 10), y_ticks = ticks_of(y_range, Math.max(5, height / 42));
  const left = 32 + 7.5 * Math.max(4, ...y_ticks.map(({text}) => text.length));
  const bottom = height - 42, right = plot_width - 24, top = 12;
  const x = scale_of(x_range, left, right), y = scale_of(y_range, bottom, top);
  for (const {value, text} of x_ticks)
    svg.append(drawn("line", {class: "grid", x1: x(value), x2: x(value), y1: top, y2: bottom}),
      drawn("text", {x: x(value), y: bottom + 17, "text-anchor": "middle"}, text));
  for (const {value, text} of y_ticks)
    svg.append(drawn("line", {class: "grid", x1: left, x2: right, y1: y(value), y2: y(value)}),
      drawn("text", {x: left - 7, y: y(value) + 4, "text-anchor": "end"}, text));
  svg.append(drawn("path", {class: "axis", d: `M${left} ${top}V${bottom}H${right}`}),
    drawn("text", {x: (left + right) / 2, y: height - 6, "text-anchor": "middle"}, x_label),
    drawn("text", {transform: `translate(14 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle"}, y_label));
  return {svg, x, y, top, bottom, left, right};
}

/** The path of a line through places of a picture; where there is none the line has a gap. */
function path_through(places) {
  let pen = "M";
  return places.map((place) => {
    if (!place) return (pen = "M", "");
    const part = `${pen}${place.x.toFixed(1)} ${place.y.toFixed(1)}${pen === "M" ? "h0" : ""}`;
    pen = "L";
    return part;
  }).join("");
}

/** A curve with its line through some places of a picture, and its markers at others. */
function draw_curve({color, marker, filled, line, dashed}, places, marked = places) {
  const group = drawn("g", {class: "curve", stroke: color});
  if (line) group.append(drawn("path", {class: dashed ? "line dashed" : "line", d: path_through(places)}));
  if (marker in marker_shapes)
    group.append(drawn("path", {class: filled ? "marker" : "open marker", fill: color,
      d: marked.filter(Boolean).map(({x, y}) => `M${x.toFixed(1)} ${y.toFixed(1)}${marker_shapes[marker]}`).join("")}));
  return group;
}

/** Draws the curves of a plot. Returns its axes, and the groups that are its curves. */
function draw_curves(plot, height) {
  const points = plot.curves.flatMap((curve) => curve.points).filter(([, y]) => y !== null);
  const axes = draw_axes({
    x_range: range_of(points.map(([x]) => x), {logarithmic: plot.log_x, from_zero: true, air: 0}),
    y_range: range_of(points.map(([, y]) => y), {logarithmic: plot.log_y, from_zero: plot.y_from_zero}),
    x_label: plot.x_label, y_label: plot.y_label, height});
  const spots = [], groups = [];
  for (const curve of plot.curves) {
    const places = curve.points.map(([x, y]) => y === null ? null : {x: axes.x(x), y: axes.y(y),
      text: () => [curve.title, `${plot.x_label}: ${number_text(x, 6)}`, `${plot.y_label}: ${number_text(y, 6)}`]});
    groups.push(draw_curve(curve, places));
    spots.push(...places.filter(Boolean));
  }
  axes.svg.append(...groups);
  tell_values(axes.svg, spots);
  return {...axes, groups};
}

const tip = document.body.appendChild(element("div", {class: "tip", hidden: ""}));

/** Marks the spot of a picture that is nearest to the pointer, and shows the lines of its text beside the pointer. */
function tell_values(svg, spots) {
  const mark = drawn("circle", {class: "mark", r: 6});
  const leave = () => {
    tip.hidden = true;
    mark.remove();
  };
  const point_at = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    let nearest, least = 40;
    for (const spot of spots) {
      const distance = Math.hypot(spot.x - at.x, spot.y - at.y);
      if (distance < least) [nearest, least] = [spot, distance];
    }
    if (!nearest) return leave();
    svg.append(filled(mark, {cx: nearest.x, cy: nearest.y}));
    tip.textContent = nearest.text().filter(Boolean).join("\n");
    tip.hidden = false;
    tip.style.left = `${Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 8)}px`;
    tip.style.top = `${Math.min(event.clientY + 14, innerHeight - tip.offsetHeight - 8)}px`;
  };
  filled(svg, {pointermove: point_at, pointerdown: point_at, pointerleave: leave});
}

/** What the curves that have a title look like. */
function legend_of(curves) {
  return element("figcaption", {}, ...curves.filter((curve) => curve.title).map((curve) =>
    element("span", {class: "legend"}, drawn("svg", {class: "swatch", viewBox: "0 0 32 12"},
      draw_curve(curve, [{x: 1, y: 6}, {x: 31, y: 6}], [{x: 16, y: 6}])), curve.title)));
}

for (const figure of document.querySelectorAll("figure.plot")) {
  const plot = JSON.parse(figure.querySelector("script").textContent);
  for (const curve of plot.curves) curve.color = palette[curve.color % palette.length];
  if (plot.curves.length > 0) figure.append(legend_of(plot.curves), draw_curves(plot, 420).svg);
  else figure.append(`There are no values to plot for ${plot.y_label} over ${plot.x_label}.`);
}
