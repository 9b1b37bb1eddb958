-- How a content is stored: null as it is (as all are from before), compressed, drawn again from a report, or in an archive. Its hash is that of the plain bytes, and its length their number.

ALTER TABLE content ADD COLUMN form TEXT;
ALTER TABLE content ADD COLUMN length BIGINT;
ALTER TABLE content ADD COLUMN source TEXT;
ALTER TABLE content ADD COLUMN made_by TEXT;

CREATE INDEX content_source ON content (source) WHERE source IS NOT NULL;

-- The last program that was sent is found from the latest step on, however many there are.
CREATE INDEX step_verified ON step (id) WHERE to_state IN ('verified');
