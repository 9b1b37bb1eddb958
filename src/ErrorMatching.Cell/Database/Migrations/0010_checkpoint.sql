-- What the audit trail says as of one of its entries, coded with the trail's key. A cell that starts goes on from there instead of reading years of entries before it sends. Without this row, or if it does not hold, the whole trail is read.

CREATE TABLE audit_checkpoint (
    only_row INTEGER NOT NULL PRIMARY KEY CHECK (only_row = 1),
    seq BIGINT NOT NULL,
    hash TEXT NOT NULL,
    state TEXT NOT NULL,
    row_code TEXT NOT NULL
);
