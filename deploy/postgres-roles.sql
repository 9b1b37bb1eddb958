-- Roles with the least rights that work, for a store on PostgreSQL. Run it as the tables' owner (the cell's user) or a superuser, in the
-- cell's database, after the cell has made its tables, and again after an update: psql --dbname=errormatch --file=postgres-roles.sql
-- For a cell with a schema of its own: PGOPTIONS='--search_path=line_1' psql --dbname=errormatch --file=postgres-roles.sql
-- Then, for each person or station: CREATE ROLE station1 LOGIN PASSWORD '...' IN ROLE errormatch_station;

DO $$
BEGIN
    IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'errormatch_reader') THEN CREATE ROLE errormatch_reader NOLOGIN; END IF;
    IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'errormatch_station') THEN CREATE ROLE errormatch_station NOLOGIN; END IF;
END $$;

DO $$
BEGIN
    EXECUTE format('GRANT USAGE ON SCHEMA %I TO errormatch_reader', current_schema());
END $$;

-- Sees corrections, programs, reports and the audit trail; no password of people or machines, not even encrypted.
GRANT SELECT ON content, correction, step, slot, audit, audit_head, audit_checkpoint, migration TO errormatch_reader;

-- Decides, and signs people in. It deletes nothing that is evidence, changes no table's form, and adds no people.
GRANT errormatch_reader TO errormatch_station;
GRANT INSERT ON content, step, audit TO errormatch_station;
GRANT INSERT, UPDATE ON correction, slot TO errormatch_station;
GRANT UPDATE ON audit_head TO errormatch_station;
GRANT SELECT, UPDATE ON person TO errormatch_station;
GRANT SELECT, INSERT, UPDATE ON credential TO errormatch_station;
GRANT SELECT, INSERT, UPDATE, DELETE ON sign_in_failure TO errormatch_station;

-- Only for a station that releases or reverts at machines that need a password: GRANT SELECT ON machine_secret TO errormatch_station;
