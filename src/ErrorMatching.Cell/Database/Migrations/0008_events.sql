-- How far the steps of each cell were published: number of the last audit entry that the broker has taken over.

CREATE TABLE event_cursor (
    cell TEXT NOT NULL PRIMARY KEY,
    seq BIGINT NOT NULL
);
