-- Who may sign in, how often that failed, and the passwords of machines. Times are microseconds since 1970-01-01 UTC.

CREATE TABLE person (
    name_key TEXT NOT NULL PRIMARY KEY,
    name TEXT NOT NULL,
    role TEXT NOT NULL,
    password TEXT NOT NULL,
    is_disabled INTEGER NOT NULL,
    added_at BIGINT NOT NULL,
    password_at BIGINT NOT NULL
);

-- By the hash of the name that was typed: what is no user's name may be a password in the wrong line.
CREATE TABLE sign_in_failure (
    name_hash TEXT NOT NULL PRIMARY KEY,
    is_user INTEGER NOT NULL,
    failures INTEGER NOT NULL,
    failed_at BIGINT NOT NULL
);

CREATE INDEX sign_in_failure_failed_at ON sign_in_failure (is_user, failed_at);

CREATE TABLE machine_secret (
    machine TEXT NOT NULL PRIMARY KEY,
    bytes {blob} NOT NULL
);
