-- Codes of rows by the key of the audit trail: what a program without the key writes into a row is found when the row is used. Each audit
-- entry names the codes of the rows that it leaves.

ALTER TABLE correction ADD COLUMN row_code TEXT;
ALTER TABLE slot ADD COLUMN row_code TEXT;
ALTER TABLE person ADD COLUMN row_code TEXT;
ALTER TABLE audit ADD COLUMN row_codes TEXT;

-- What has none yet is looked for whenever a store is opened.
CREATE INDEX correction_uncoded ON correction (id) WHERE row_code IS NULL;
