"use strict";

// Colour maps as a few colours each, between which a map is linear.

const colourMaps = {
  viridis: ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"],
  turbo: ["#30123b", "#4662d7", "#36aaf9", "#1ae4b6", "#72fe5e", "#c8ef34", "#faba39", "#f66b19", "#cb2a04", "#7a0403"],
  heat: ["#2b2d42", "#5b3a63", "#933f6b", "#c64e5f", "#ea7246", "#fba13c", "#fdd25f", "#fdf6b5"],
  diverging: ["#2c5fa8", "#5b8fcf", "#9dbfe3", "#e3e6ea", "#eeb09a", "#d96f5a", "#aa2c38"],
};

/** For things without an order, such as materials. */
const categoryColours = [
  "#7fa3c7", "#d6a15f", "#8db08a", "#b58ab5", "#c97b74", "#6fb5b2", "#c4b76a", "#8c8cc4", "#a88a72", "#7f9aa6",
];

const rgbOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

/** 256 colours of a map, as bytes r, g, b, a. */
function colourTable(name) {
  const stops = colourMaps[name].map(rgbOf), table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    const place = (i / 255) * (stops.length - 1), lower = Math.min(Math.floor(place), stops.length - 2);
    for (let c = 0; c < 3; ++c)
      table[4 * i + c] = Math.round(stops[lower][c] + (place - lower) * (stops[lower + 1][c] - stops[lower][c]));
    table[4 * i + 3] = 255;
  }
  return table;
}

/** Categories, each with the same colour over its part of the table. */
function categoryTable(count) {
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    const category = Math.min(Math.floor((i * count) / 256), count - 1);
    table.set([...rgbOf(categoryColours[category % categoryColours.length]), 255], 4 * i);
  }
  return table;
}
