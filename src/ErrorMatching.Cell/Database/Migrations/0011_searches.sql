-- What is looked for often and is rare: measurements that were given again, in line; the contents in archives, by archive; and who signed
-- in, failed to, or may try again.

CREATE INDEX correction_again ON correction (machine, slot, state, measured_as) WHERE measured_as IS NOT NULL;
CREATE INDEX content_archive ON content (source) WHERE form = 'archive';
CREATE INDEX audit_sign_in ON audit (who, seq) WHERE what IN ('sign-in-failed', 'locked', 'signed-in');
CREATE INDEX audit_unlocked ON audit (subject, seq) WHERE what IN ('user-added', 'user-enabled', 'password-set');
