using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Freeform.Tests;

public sealed class MeasuredSurfaceReaderTests
{
    private static readonly MeasuringPlan Plan = Programs.Plan(Surfaces.Three);

    [Fact]
    public void Centers_become_the_contacts_that_they_came_of_wherever_the_ball_touched() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(50), Prop.ForAll<int>(IsExact));

    private static void IsExact(int seed)
    {
        // The ball touches a surface that lies 0.2 mm and an error over the nominal one,
        // up to half a millimeter aside of where it was sent.
        var random = new Random(seed);
        var (centers, contacts) = (new Point3[Plan.Points.Count], new Point3[Plan.Points.Count]);
        for (var i = 0; i < centers.Length; i++)
        {
            var point = Plan.Points[i];
            var at = Plan.Surface.Spline.At(point.U + ((random.NextDouble() - 0.5) / 75), point.V + ((random.NextDouble() - 0.5) / 63));
            contacts[i] = at.Position + (at.Normal * (0.2 + (0.1 * random.NextDouble())));
            centers[i] = contacts[i] + (at.Normal * 3);
        }

        var measured = Read(Programs.Log(Plan, p => centers[p.Number - 1]));
        Assert.All(measured.Points, p => Assert.True((p.Contact - contacts[p.Planned.Number - 1]).Length < 1e-9));
        Assert.Equal(measured.Points[4].Contact, measured[5]);
    }

    [Fact]
    public void The_planned_normal_would_be_wrong_on_a_slope()
    {
        // On a slope of 45 degrees that turns with a radius of 40 mm, a touch 0.5 mm aside makes 3 µm if the planned normal is taken:
        // 0.5²/2 (1/40 - ...) - the contact found here has none of it.
        var plan = Programs.Plan(Surfaces.Quadratic((x, _) => -x * x / 80));
        var point = plan.Points.First(p => p.I == 2);
        var at = plan.Surface.Spline.At(point.U + (0.5 / 75), point.V);
        var center = at.Position + (at.Normal * (3 + 0.2));
        var log = Programs.Log(plan, p => p == point ? center : plan.CenterOf(p));
        var contact = MeasuredSurfaceReader.Read(Encoding.UTF8.GetBytes(log), "log", plan, plan.Measuring)[point.Number];
        Assert.True((contact - (at.Position + (at.Normal * 0.2))).Length < 1e-9);
        Assert.True((contact - (center + (point.Normal * -3))).Length > 0.005);
    }

    [Fact]
    public void Logs_may_be_padded_as_controls_pad_them()
    {
        var lines = Programs.Log(Plan, Plan.CenterOf).Split('\n');
        for (var i = 1; i < lines.Length; i++)
        {
            lines[i] = lines[i].Replace("X", "X   ", StringComparison.Ordinal)
                .Replace("Z-", "Z-  ", StringComparison.Ordinal)
                .Replace("P", "P  ", StringComparison.Ordinal);
        }

        var measured = Read("%_N_ERRORMATCH_MPF\r\n;$PATH=/_N_MPF_DIR\r\n" + string.Join("\r\n", lines) + "%\r\n");
        Assert.All(measured.Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 1e-9));
        Assert.Empty(measured.Warnings);
    }

    // LinuxCNC writes centers of the ball without labels. A results file has the radius of its ball, so it has contacts already.
    [Fact]
    public void Logs_of_controls_have_the_points_of_the_plan_in_its_order()
    {
        var measuring = Plan.Measuring with { ReportsStylusCenter = true };
        var log = string.Concat(Plan.Points.Select(Plan.CenterOf).Select(
            c => FormattableString.Invariant($"{c.X:F6} {c.Y:F6} {c.Z:F6} 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n")));
        var results = string.Concat(Plan.Points.Select(p => FormattableString.Invariant(
            $"G800 N{p.Number} {Words(Plan.ContactOf(p))} I{p.Normal.X:F9} J{p.Normal.Y:F9} K{p.Normal.Z:F9}\n")
            + FormattableString.Invariant($"G801 N{p.Number} {Words(Plan.CenterOf(p))} R{Plan.StylusRadiusMm:F6}\n")));
        foreach (var text in (string[])[log, results])
        {
            Assert.All(Read(text, measuring).Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 2e-6));
        }

        var error = Assert.Throws<InputException>(() => Read(log[(log.IndexOf('\n', StringComparison.Ordinal) + 1)..], measuring));
        Assert.Equal(MeasurementError.PointCount, error.Code);

        static string Words(Point3 p) => FormattableString.Invariant($"X{p.X:F6} Y{p.Y:F6} Z{p.Z:F6}");
    }

    [Theory]
    [InlineData("1.2E-07", 1.2e-7)]
    [InlineData("-5.EX-6", -5e-6)]
    [InlineData("+2.5e+0", 2.5)]
    public void A_value_close_to_nothing_may_have_an_exponent(string written, double read)
    {
        // At the corner x = 0 the contact is close to nothing, too.
        var log = Programs.Log(Plan, Plan.CenterOf).Split('\n');
        var corner = Plan.Points.Single(p => p.I == 0 && p.J == 0);
        var contact = Plan.ContactOf(corner);
        log[corner.Number] = FormattableString.Invariant($"P{corner.Number} S X{written} Y{contact.Y:R} Z{contact.Z:R}");
        Assert.Equal(
            contact with { X = read },
            Read(string.Join('\n', log), Plan.Measuring with { ApproachMm = 10, OvertravelMm = 10 })[corner.Number]);
    }

    [Fact]
    public void A_contact_in_a_log_is_taken_as_it_is()
    {
        var contact = Plan.ContactOf(Plan.Points[0]) + new Vector3(0, 0, 0.01);
        var log = Programs.Log(Plan, Plan.CenterOf).Split('\n');
        log[1] = string.Create(CultureInfo.InvariantCulture, $"P1 S X{contact.X:R} Y{contact.Y:R} Z{contact.Z:R}");
        Assert.Equal(contact, Read(string.Join('\n', log))[1]);
    }

    [Theory]
    [InlineData(',')]
    [InlineData(';')]
    [InlineData('\t')]
    public void Tables_name_points_by_their_numbers_or_by_their_places(char delimiter)
    {
        string Row(string first, PlanPoint p) =>
            first
                + FormattableString.Invariant(
                    $",{Plan.ContactOf(p).X:R},{Plan.ContactOf(p).Y:R},{Plan.ContactOf(p).Z:R}\n").Replace(',', delimiter);
        var byNumber = $"point{delimiter}x{delimiter}y{delimiter}z\n"
            + string.Concat(Plan.Points.Select(p => Row(FormattableString.Invariant($"P{p.Number}"), p)));
        var byPlace = $"j{delimiter}i{delimiter}x{delimiter}y{delimiter}z\n"
            + string.Concat(Plan.Points.Reverse().Select(p => Row(FormattableString.Invariant($"{p.J}{delimiter}{p.I}"), p)));
        foreach (var text in (string[])[byNumber, byPlace])
        {
            var measured = Read(text);
            Assert.All(measured.Points, p => Assert.Equal(Plan.ContactOf(p.Planned), p.Contact));
            Assert.Empty(measured.Warnings);
        }
    }

    [Fact]
    public void Tables_hold_centers_where_the_job_says_so()
    {
        var text = "point,x,y,z\n"
            + string.Concat(Plan.Points.Select(p => FormattableString.Invariant(
                $"{p.Number},{Plan.CenterOf(p).X:R},{Plan.CenterOf(p).Y:R},{Plan.CenterOf(p).Z:R}\n")));
        var measured = Read(text, Plan.Measuring with { ReportsStylusCenter = true });
        Assert.All(measured.Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 1e-9));
        Assert.Contains("stylus-center", Assert.Throws<InputException>(() => Read(text)).Message, StringComparison.Ordinal);
    }

    // One surface in three spellings: the gauge of a shop with decimal commas, in inches, or with names of its own.
    [Theory]
    [InlineData("""{ "delimiter": ";", "decimalComma": true, "skipLines": 2, "columns": { "label": "Nr", "x": "X-Ist", "y": "Y-Ist", "z": "Z-Ist" } }""")]
    [InlineData("""{ "delimiter": "\t", "unit": "inch", "encoding": "utf-16", "columns": { "label": 1, "x": 2, "y": 3, "z": 4 } }""")]
    [InlineData("""{ "kind": "grid", "delimiter": "|", "columns": { "i": "u", "j": "v", "x": "x", "y": "y", "z": "z" } }""")]
    public void A_gauge_s_file_is_read_as_the_job_describes_it(string description)
    {
        var format = MeasurementFormat.FromJson(description);
        var scale = format.Unit == LengthUnit.Inch ? 1 / 25.4 : 1;
        var isGrid = format.Kind == "grid";
        var head = format.SkipLines > 0 ? "Teil: 4711\nPrüfer: Wang\nNr|X-Ist|Y-Ist|Z-Ist\n" : isGrid ? "x|y|z|v|u\n" : "";
        var text = head + string.Concat(Plan.Points.Select(p =>
        {
            var at = Plan.ContactOf(p);
            var place = string.Create(CultureInfo.InvariantCulture, $"{at.X * scale:R}|{at.Y * scale:R}|{at.Z * scale:R}");
            place = format.DecimalComma ? place.Replace('.', ',') : place;
            return isGrid
                ? string.Create(CultureInfo.InvariantCulture, $"{place}|{p.J}|{p.I}\n")
                : string.Create(CultureInfo.InvariantCulture, $"P{p.Number}|{place}\n");
        }));
        text = text.Replace('|', format.Delimiter);
        var bytes = format.Encoding == "utf-16" ? Encoding.Unicode.GetBytes(text) : Encoding.UTF8.GetBytes(text);
        var measured = MeasuredSurfaceReader.Read(bytes, "measured.csv", Plan, Plan.Measuring with { Format = format });
        Assert.All(measured.Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 1e-9));
        Assert.Equal(head.Count(c => c == '\n') + 1, measured.Points[0].Line);
    }

    [Theory]
    [InlineData("measured.qif")]
    [InlineData("measured.dfq")]
    [InlineData("measured.dmo")]
    [InlineData("measured_chr.txt")]
    [InlineData("measured.txt")]
    public void A_file_that_shows_its_format_needs_no_description(string name)
    {
        var bytes = Encoding.UTF8.GetBytes(GaugeFiles.Of(name, [.. Plan.Points.Select(p => ($"P{p.Number}", Plan.ContactOf(p)))]));
        var measured = MeasuredSurfaceReader.Read(bytes, name, Plan, Plan.Measuring);
        Assert.All(measured.Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 1e-4));
        var random = new Random(3);
        Assert.InRange(Enumerable.Range(0, 200).Count(_ => Survives(Damaged.Of(bytes, random))), 0, 195);
    }

    [Fact]
    public void A_log_is_read_whatever_format_the_gauge_has() =>
        Assert.Equal(20, Read(Log(), Plan.Measuring with { Format = MeasurementFormat.FeatureTable }).Points.Count);

    // The fourth point of the plan, by its number, and where it is not in the grid.
    [Fact]
    public void Columns_that_contradict_each_other_are_refused()
    {
        string Table(int off) =>
            "point,i,j,x,y,z\n"
                + string.Concat(Plan.Points.Select(p => string.Create(
                    CultureInfo.InvariantCulture,
                    $"{p.Number},{p.I + (p.Number == 4 ? off : 0)},{p.J},{Plan.ContactOf(p).X:R},{Plan.ContactOf(p).Y:R},"
                        + $"{Plan.ContactOf(p).Z:R}\n")));
        Assert.Equal(20, Read(Table(0)).Points.Count);
        Refused(
            Table(1),
            "contradictory-point",
            5,
            $"found point 4 with i {Plan.Points[3].I + 1}, j {Plan.Points[3].J}; in the plan it is i {Plan.Points[3].I}, j "
                + $"{Plan.Points[3].J}.");
    }

    [Theory]
    [InlineData(',')]
    [InlineData(';')]
    [InlineData('\t')]
    public void Gauge_tables_of_features_are_read(char delimiter)
    {
        var text = GaugeTable().Replace(',', delimiter);
        Assert.All(Read(text).Points, p => Assert.True((p.Contact - Plan.ContactOf(p.Planned)).Length < 1e-4));
    }

    [Fact]
    public void A_decimal_comma_between_commas_is_no_other_number() =>
        Refused(
            "point,x,y,z\n1,0,5000,0,2500,30,1000\n",
            "long-row",
            2,
            "needs semicolons or tabs between its cells, and \"decimalComma\": true");

    [Fact]
    public void A_missing_point_is_named() => Refused(Without(3), "missing-point", null, "missing: 3.");

    [Fact]
    public void A_doubled_point_is_named_with_both_lines() =>
        Refused(Log() + Log().Split('\n')[4] + "\n", "doubled-point", 22, "point 4 is here a second time, the first is in line 5");

    [Fact]
    public void A_point_that_the_plan_has_not_is_named() => Refused(Log() + "P21 C X0 Y0 Z0\n", "unknown-point", 22, "point 21");

    [Fact]
    public void A_far_off_point_is_named_with_its_distance() =>
        Refused(
            Programs.Log(Plan, p => p.Number == 6 ? Plan.CenterOf(p) + (p.Normal * 5) : Plan.CenterOf(p)),
            "far-off-point",
            7,
            "point 6 is 5 mm from where it is expected (5 mm along the normal");

    [Fact]
    public void A_point_beyond_all_machines_is_named_in_few_digits() =>
        Refused(
            Log().Split('\n')[0] + "\n"
                + string.Concat(Plan.Points.Select(p => string.Create(
                    CultureInfo.InvariantCulture,
                    $"P{p.Number} S X{Plan.ContactOf(p).X:R} Y{Plan.ContactOf(p).Y:R} "
                        + $"Z{(p.Number == 6 ? 1e200 : Plan.ContactOf(p).Z):R}\n"))),
            "far-off-point",
            7,
            "point 6 is more than 1E+150 mm from where it is expected");

    [Fact]
    public void A_touch_that_found_nothing_is_far_off() => Refused(
        Programs.Log(Plan, p => p.Number == 6 ? Plan.OvertravelOf(p) : Plan.CenterOf(p)), "far-off-point", 7, "(-2 mm along the normal");

    [Theory]
    [InlineData(1, "reaches less than 1.995 mm. Measure it again.")]
    [InlineData(2, "reaches less than 1.995 mm. 1 other point is beyond that, too. Measure it again.")]
    [InlineData(4, "reaches less than 1.995 mm. 3 other points are beyond that, too. Measure it again.")]
    public void As_many_others_are_named_as_there_are(int count, string said) =>
        Refused(
            Programs.Log(Plan, p => p.Number <= count ? Plan.CenterOf(p) + new Vector3(0, 0, 5) : Plan.CenterOf(p)),
            "far-off-point",
            2,
            said);

    [Fact]
    public void Points_out_of_order_are_a_warning()
    {
        var lines = Log().Split('\n');
        (lines[5], lines[6]) = (lines[6], lines[5]);
        var measured = Read(string.Join('\n', lines));
        var warning = Assert.Single(measured.Warnings);
        Assert.Equal("points-out-of-order", warning.Code);
        Assert.Equal(["7", "5", "6"], warning.Values.Skip(1));
        Assert.Equal(7, measured.Points[4].Line);
    }

    [Fact]
    public void A_log_of_another_plan_is_refused() =>
        Refused(Programs.Log(Programs.Plan(Surfaces.Two), Plan.CenterOf), "other-plan", 1, "belongs to the plan");

    [Fact]
    public void A_log_may_say_that_it_is_whole_and_then_says_no_more()
    {
        Assert.Equal(Read(Log())[1], Read(Log() + "END\n%\n")[1]);
        Refused(Log() + "END\nP1 C X1 Y2 Z3\n", "bad-log", 23, "behind END in line 22");
        Refused(Log() + "END\n" + Log(), "two-runs", 23, "began in line 1");
    }

    [Fact]
    public void Two_runs_in_one_log_are_refused() => Refused(Log() + Log(), "two-runs", 22, "began in line 1");

    [Theory]
    [InlineData("", "empty-file", null, null, "the file is empty", "a log, or a table with a header, is expected")]
    [InlineData("\n% \n", "empty-file", null, null, "the file is empty", "a log, or a table with a header, is expected")]
    [InlineData("hello", "missing-column", 1, 1, "the columns \"hello\"", "expected a column point")]
    [InlineData("x,y,z\n1,2,3\n", "missing-column", 1, 1, "the columns \"x\", \"y\", \"z\"", "expected a column point")]
    [InlineData("point,x,y\n1,2,3\n", "missing-coordinate", 2, null, "no Z of the point \"1\"", "expected X, Y and Z")]
    [InlineData("point,x,y,z\n1,2,3\n", "short-row", 2, 4, "a line of 3 cells", "expected 4 cells as in the first line")]
    [InlineData("point,x,y,z\n1,2,3,4,5\n", "long-row", 2, 5, "a line of 5 cells", "expected 4 cells as in the first line")]
    [InlineData("point,x,y,z\n1,2,3,NaN\n", "not-a-number", 2, 4, "found \"NaN\"", "measure the point again")]
    [InlineData("point;x;y;z\n1;2;3;4,5\n", "decimal-comma", 2, 4, "found \"4,5\"", "set \"decimalComma\": true in the \"format\"")]
    [InlineData("point,x,y,z\n1,2,3,1e200\n", "implausible-number", 2, 4, "found \"1e200\"", "within a kilometer")]
    [InlineData("point,x,y,z\none,2,3,4\n", "bad-number", 2, null, "found the point \"one\"", "the number of a point of the plan")]
    [InlineData("i,j,x,y,z\n0,0.5,2,3,4\n", "text-for-number", 2, 2, "found \"0.5\"", "expected a whole number")]
    [InlineData("i,j,x,y,z\n0,0,2,3,4\n0,0,2,3,4\n", "duplicate-point", 3, 1, "found \"0\"", "line 2 has 0,0 already")]
    [InlineData("point,i,j,x,y,z\n1,a,0,2,3,4\n", "text-for-number", 2, null, "found \"a\"", "expected a whole number as in plan.csv")]
    [InlineData("point,x,x_mm,y,z\n1,2,3,4,5\n", "duplicate-column", 1, 3, "a second column for x", "each needed column once")]
    [InlineData(
        "feature,item,nominal,actual,deviation\nA,X,1,1,0\nA,Y,1,1,0\nA,Z,1,1,0\n",
        "bad-number",
        2,
        null,
        "the point \"A\"",
        "expected the number of a point of the plan")]
    [InlineData(
        "feature,item,nominal,actual,deviation\nP1,X,1,1,0\nP1,Y,1,1,0\n",
        "missing-coordinate",
        2,
        null,
        "no Z of the point \"P1\"",
        "expected X, Y and Z")]
    [InlineData(
        "ERRORMATCH PROBE\n",
        "bad-log",
        1,
        null,
        "found \"ERRORMATCH PROBE\"",
        "expected ERRORMATCH PROBE PLAN, the plan's number, and MM")]
    [InlineData("ERRORMATCH PROBE PLAN 0 INCH\n", "bad-log", 1, null, "the unit \"INCH\"", "expected MM")]
    [InlineData("i,j,x,y,z\n99,0,2,3,4\n", "unknown-point", 2, null, "the point i 99, j 0", "the plan has i from 0 to 4 and j from 0 to 3")]
    [InlineData("point,x,y,z\n\0", "binary-file", 2, 1, "the control character 0x00", "expected text")]
    [InlineData("point,x,y,z\n\u00ff", "invalid-encoding", 2, 1, "byte 0xFF", "expected text in utf-8")]
    [InlineData("ERRORMATCH \0", "binary-file", null, null, "a NUL character", "expected text")]
    [InlineData("ERRORMATCH \u00ff", "invalid-encoding", null, null, "bytes that are no UTF-8 text", "expected UTF-8")]
    public void What_is_no_measurement_is_refused(string text, string code, int? line, int? column, string found, string expected)
    {
        var error = Assert.Throws<InputException>(() => MeasuredSurfaceReader.Read(
            Encoding.Latin1.GetBytes(text), "measured.csv", Plan, Plan.Measuring));
        Assert.Equal((code, "measured.csv", line, column), (error.Code, error.File, error.Place.Line, error.Place.Column));
        Assert.Contains(found, error.Message, StringComparison.Ordinal);
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_file_larger_than_any_measurement_is_refused() =>
        Assert.Equal(
            "file-too-large",
            Assert.Throws<InputException>(() => MeasuredSurfaceReader.Read(
                new byte[MeasuredSurfaceReader.MaxBytes + 1], "measured.csv", Plan, Plan.Measuring)).Code);

    [Theory]
    [InlineData("P1 C X1 Y2")]
    [InlineData("P1 X1 Y2 Z3")]
    [InlineData("P1 C X1 Y2 Z3 Q4")]
    [InlineData("P1.5 C X1 Y2 Z3")]
    [InlineData("P1 C X1 Y2 Z1.2.3")]
    public void A_line_of_a_log_that_is_no_point_is_refused_with_its_line(string line) =>
        Refused(Log().Split('\n')[0] + "\n" + line, "bad-log", 2, "expected a point such as");

    [Fact]
    public void Whatever_bytes_come_nothing_but_the_library_s_errors_does() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(200), Prop.ForAll<byte[]>(bytes => { Survives(bytes); }));

    [Theory]
    [InlineData("log")]
    [InlineData("table")]
    [InlineData("gauge")]
    public void A_damaged_file_is_read_or_refused(string kind)
    {
        var good = Encoding.UTF8.GetBytes(
            kind == "log"
                ? Log() + "END\n"
                : kind == "gauge"
                ? GaugeTable()
                : "point,x,y,z\n"
                    + string.Concat(Plan.Points.Select(p => string.Create(
                        CultureInfo.InvariantCulture,
                        $"{p.Number},{Plan.ContactOf(p).X:0.0000},{Plan.ContactOf(p).Y:0.0000},{Plan.ContactOf(p).Z:0.0000}\n"))));
        Assert.True(Survives(good));
        var random = new Random(1);
        var read = Enumerable.Range(0, 400).Count(_ => Survives(Damaged.Of(good, random)));
        Assert.InRange(read, 1, 390);
    }

    // True if it was read.
    private static bool Survives(byte[] bytes)
    {
        try
        {
            return MeasuredSurfaceReader.Read(bytes, "any", Plan, Plan.Measuring).Points.Count == Plan.Points.Count;
        }
        catch (InputException e)
        {
            Assert.NotEmpty(e.Problem);
            return false;
        }
    }

    private static string GaugeTable() =>
        "feature,item,nominal,actual,deviation\n" + string.Concat(Plan.Points.SelectMany(p => "XYZ".Select(axis =>
        {
            var value = Math.Round(axis == 'X' ? Plan.ContactOf(p).X : axis == 'Y' ? Plan.ContactOf(p).Y : Plan.ContactOf(p).Z, 4);
            return FormattableString.Invariant($"P{p.Number},{axis},{value:0.0000},{value:0.0000},0\n");
        })));

    private static string Log() => Programs.Log(Plan, Plan.CenterOf);

    private static string Without(int number) => string.Join('\n', Log().Split('\n').Where((_, i) => i != number));

    private static MeasuredPoints Read(string text, JobMeasuring? measuring = null) =>
        MeasuredSurfaceReader.Read(Encoding.UTF8.GetBytes(text), "measured.csv", Plan, measuring ?? Plan.Measuring);

    private static void Refused(string text, string code, int? line, string reason)
    {
        var error = Assert.Throws<InputException>(() => Read(text));
        Assert.Equal((code, "measured.csv", line), (error.Code, error.File, error.Place.Line));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }
}
