-- Number of the correction that a measurement came in with, where it was given again to be computed anew: that one's place in line and what its piece was compared with hold on.

ALTER TABLE correction ADD COLUMN measured_as BIGINT REFERENCES correction (id);
