-- A correction by an offset of the control: what its program sets, and the program that takes it back. Both are null where the program itself is corrected.

ALTER TABLE correction ADD COLUMN control_offset TEXT;
ALTER TABLE correction ADD COLUMN undo_sha256 TEXT REFERENCES content (sha256);
