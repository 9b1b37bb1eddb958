// Looks for words in all pages. It reads pages.js, which deploy/site writes beside it, and nothing from a network: it works from a disk.
'use strict';

const most = 40;
const around = 90;
const box = document.getElementById('words');
const found = document.getElementById('found');
let all = [];

// How well a page answers: words in the title count most. Zero if one word is nowhere on the page.
function score(page, words) {
    let sum = 0;
    for (const word of words) {
        const times = page.text.split(word).length - 1;
        const isTitle = page.name.includes(word);
        if (times === 0 && !isTitle) {
            return 0;
        }

        sum += Math.min(times, 10) + (isTitle ? 30 : 0);
    }

    // A page of a task before the reference of the libraries.
    return page.href.startsWith('docs/api/') ? sum / 10 : sum;
}

const nameOf = page => page.title.replace(/ \| ErrorMatching$/, '');

function excerpt(page, word) {
    const at = Math.max(0, page.text.indexOf(word) - around);
    return (at > 0 ? '… ' : '') + page.summary.slice(at, at + 3 * around) + ' …';
}

function show() {
    const words = box.value.toLowerCase().split(/\s+/).filter(word => word.length > 0);
    const hits = words.length === 0 ? [] : all
        .map(page => ({ page, points: score(page, words) }))
        .filter(hit => hit.points > 0)
        .sort((a, b) => b.points - a.points || a.page.href.localeCompare(b.page.href, 'en'));
    found.replaceChildren(...hits.slice(0, most).map(({ page }) => {
        const [entry, link, text] = ['div', 'a', 'p'].map(name => document.createElement(name));
        link.href = '../../' + page.href;
        link.textContent = nameOf(page);
        text.textContent = excerpt(page, words[0]);
        entry.append(link, text);
        return entry;
    }));
    if (words.length > 0 && hits.length === 0) {
        found.textContent = 'Nothing has all of these words.';
    }
}

const script = document.createElement('script');
script.src = 'pages.js';
script.addEventListener('load', () => {
    all = Object.values(pages).map(page => ({ ...page, name: nameOf(page).toLowerCase(), text: page.summary.toLowerCase() }));
    box.addEventListener('input', show);
    box.value = new URLSearchParams(location.search).get('q') ?? '';
    show();
});
document.head.append(script);
