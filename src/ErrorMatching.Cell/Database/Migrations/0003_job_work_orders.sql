-- The work order that the job names. Pieces that say none of their own are found by it; whether two pieces belong together is told by their own.

ALTER TABLE correction ADD COLUMN job_work_order TEXT;

CREATE INDEX correction_job_work_order ON correction (job_work_order);
