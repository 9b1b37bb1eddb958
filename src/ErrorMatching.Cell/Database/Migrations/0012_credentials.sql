-- How people may sign in besides their passwords: a PIN or a badge, as hashes alone. An empty hash is of one that was taken away: its row stays, so that an earlier row that somebody puts back does not agree with the trail.

CREATE TABLE credential (
    name_key TEXT NOT NULL,
    kind TEXT NOT NULL,
    hash TEXT NOT NULL,
    set_at BIGINT NOT NULL,
    row_code TEXT NOT NULL,
    PRIMARY KEY (name_key, kind)
);

CREATE UNIQUE INDEX credential_badge ON credential (hash) WHERE kind = 'badge' AND hash <> '';
