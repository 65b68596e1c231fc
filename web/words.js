// The words of the page, in the language that the reader chose.

// Of each key the words in English and in Korean.
let words = {};
let language = "en";

export async function wordsLoaded(record) {
  const kept = localStorage.getItem("language");
  language = kept || ((navigator.language || "").startsWith("ko") ? "ko" : "en");
  words = record ? record.words : await (await fetch(document.getElementById("words").href)).json();
  document.documentElement.lang = language;
}

export const tongue = () => language;

export function w(key, ...given) {
  const word = words[key]?.[language === "ko" ? 1 : 0];
  if (word === undefined) throw new Error("no word: " + key);
  return word.replace(/\{(\d)\}/g, (_, i) => given[i]);
}

export function otherTongue() {
  language = language === "ko" ? "en" : "ko";
  localStorage.setItem("language", language);
  document.documentElement.lang = language;
  reworded(document);
  document.dispatchEvent(new Event("reworded"));
}

// data-word is the key of the text of an element, data-label of its name.
export function reworded(root) {
  for (const element of root.querySelectorAll("[data-word]")) {
    element.textContent = w(element.dataset.word);
  }
  for (const element of root.querySelectorAll("[data-label]")) {
    element.setAttribute("aria-label", w(element.dataset.label));
    if (element.getAttribute("role") !== "region") element.setAttribute("title", w(element.dataset.label));
  }
}

// What a message of the program says.
export const said = (message) => message.words[language];
