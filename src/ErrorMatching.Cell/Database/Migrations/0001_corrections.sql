-- What arrives, what becomes of it, and who did what. Times are microseconds since 1970-01-01 UTC; hashes are SHA-256 in lower-case hexadecimal digits.

CREATE TABLE content (
    sha256 TEXT NOT NULL PRIMARY KEY,
    bytes {blob} NOT NULL
);

CREATE TABLE correction (
    id {identity},
    state TEXT NOT NULL,
    version BIGINT NOT NULL,
    arrival TEXT NOT NULL UNIQUE,
    gauge TEXT NOT NULL,
    file_name TEXT NOT NULL,
    arrived_at BIGINT NOT NULL,
    changed_at BIGINT NOT NULL,
    measurement_sha256 TEXT NOT NULL,
    measurement_bytes BIGINT NOT NULL,
    job TEXT,
    piece TEXT,
    serial TEXT,
    work_order TEXT,
    identity TEXT UNIQUE,
    job_sha256 TEXT REFERENCES content (sha256),
    base_sha256 TEXT REFERENCES content (sha256),
    part_sha256 TEXT REFERENCES content (sha256),
    machine TEXT,
    slot TEXT,
    program TEXT,
    program_sha256 TEXT REFERENCES content (sha256),
    report_sha256 TEXT REFERENCES content (sha256),
    page_sha256 TEXT REFERENCES content (sha256),
    largest_mm DOUBLE PRECISION,
    sum_mm DOUBLE PRECISION,
    sums_sha256 TEXT REFERENCES content (sha256),
    previous_sha256 TEXT REFERENCES content (sha256),
    code TEXT,
    reason TEXT,
    trace TEXT
);

CREATE INDEX correction_state ON correction (state, id);
CREATE INDEX correction_measurement ON correction (measurement_sha256);
CREATE INDEX correction_slot ON correction (machine, slot, state, id);
CREATE INDEX correction_serial ON correction (serial);
CREATE INDEX correction_work_order ON correction (work_order);
CREATE INDEX correction_arrived_at ON correction (arrived_at);
CREATE INDEX correction_program ON correction (program);
CREATE INDEX correction_program_sha256 ON correction (program_sha256);

CREATE TABLE step (
    id {identity},
    correction BIGINT NOT NULL REFERENCES correction (id),
    from_state TEXT,
    to_state TEXT NOT NULL,
    at BIGINT NOT NULL,
    who TEXT NOT NULL,
    basis TEXT NOT NULL
);

CREATE INDEX step_correction ON step (correction, id);
CREATE INDEX step_who ON step (who, correction);

CREATE TABLE slot (
    machine TEXT NOT NULL,
    slot TEXT NOT NULL,
    correction BIGINT REFERENCES correction (id),
    program_sha256 TEXT REFERENCES content (sha256),
    previous_sha256 TEXT REFERENCES content (sha256),
    PRIMARY KEY (machine, slot)
);

CREATE TABLE audit (
    seq BIGINT NOT NULL PRIMARY KEY,
    at BIGINT NOT NULL,
    who TEXT NOT NULL,
    what TEXT NOT NULL,
    subject TEXT,
    basis TEXT NOT NULL,
    previous TEXT NOT NULL,
    hash TEXT NOT NULL
);

{append_only:audit}

-- The one row that says where the audit trail ends, so that a removed tail is found; its row lock puts the writers of all cells in one order.
CREATE TABLE audit_head (
    only_row INTEGER NOT NULL PRIMARY KEY CHECK (only_row = 1),
    seq BIGINT NOT NULL,
    at BIGINT NOT NULL,
    hash TEXT NOT NULL,
    seal TEXT
);

INSERT INTO audit_head (only_row, seq, at, hash) VALUES (1, 0, 0, '0000000000000000000000000000000000000000000000000000000000000000');
