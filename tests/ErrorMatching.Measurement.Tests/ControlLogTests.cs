using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement.Tests;

public class ControlLogTests
{
    private const string ProbeOpen = "1.000000 2.000000 3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n";

    public static TheoryData<string> Names => [.. ControlLogs.All.Keys];

    // To the digits that a log prints: three decimals for grbl and Siemens, four or more for the others.
    [Theory]
    [MemberData(nameof(Names))]
    public void Each_log_has_the_points_of_its_table(string name)
    {
        var table = Text.Read(ControlLogs.Table);
        var last = name.StartsWith("grbl", StringComparison.Ordinal) || name == "siemens" ? 0.000_500_001 : 1e-9;
        foreach (var format in (MeasurementFormat[])[MeasurementFormat.Points, MeasurementFormat.Recognized])
        {
            var log = MeasurementReader.Read(ControlLogs.Bytes(ControlLogs.All[name]), "log.txt", format);
            Assert.Equal(ControlLogs.ByOrder.Contains(name), log.IsByOrder);
            Assert.Equal(table.Points.Count, log.Points.Count);
            Assert.Equal(name.StartsWith("results", StringComparison.Ordinal), log.IsContact);
            foreach (var point in table.Points)
            {
                var found = log[point.Label];
                Assert.InRange(Math.Abs(found.Position.X - point.Position.X), 0, last);
                Assert.InRange(Math.Abs(found.Position.Y - point.Position.Y), 0, last);
                Assert.True(!found.HasZ || Math.Abs(found.Position.Z - point.Position.Z) <= last);
            }
        }
    }

    [Theory]
    [InlineData("%\nP1 X 1.0 Y 2.0\n%\n", "P1")]
    [InlineData("%\nN07 X 1.0 Y 2.0\n%\n", "N07")]
    public void A_label_with_letters_is_also_called_by_its_number(string text, string label)
    {
        var log = Text.Read(text);
        Assert.Equal(label, Assert.Single(log.Points).Label);
        Assert.Equal(log[label], log[label[1..].TrimStart('0')]);
    }

    [Fact]
    public void Two_labels_with_the_same_number_are_not_mistaken_for_each_other() => Assert.Equal(
        MeasurementError.MissingPoint,
        Assert.Throws<InputException>(() => Text.Read("%\nP1 X1.0 Y2.0\nP01 X3.0 Y4.0\n%\n")["1"]).Code);

    [Theory]
    [InlineData("[PRB:1.000,2.000,3.000:1]\n[PRB:1.000,2.000,3.000:0]\n", MeasurementError.MissedTouch, 2, 4)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\n[PRB:1.000,2.0\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("[PRB:1.000,2.000:1]\n", MeasurementError.BadStructure, 1, 2)]
    [InlineData("[PRB:1.000,2.000,3.000]\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("[PRB:1.000,x,3.000:1]\n", MeasurementError.TextForNumber, 1, 2)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\nALARM:5\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("G38.2Z-5 < [PRB:1.000,2.000,3.000:1]\nG38.2Z-5 < ALARM:4\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("G38.3Z-5 < [PRB:1.000,2.000,3.000:0]\n", MeasurementError.MissedTouch, 1, 4)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\nP1 X1.0 Y2.0\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\nerror:9\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\n$13=1\n", MeasurementError.UnknownUnit, 2, 1)]
    [InlineData("[PRB:1.000,2.000,3.000:1]\n" + ProbeOpen, MeasurementError.BadStructure, 2, 1)]
    [InlineData(ProbeOpen + "1.000000 2.000000 3.000000\n", MeasurementError.ShortRow, 2, 4)]
    [InlineData(ProbeOpen + "1 2 3 0 0 0 0 0 0 0\n", MeasurementError.LongRow, 2, 10)]
    [InlineData(
        ProbeOpen + "1.000000 2.000000 3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.00", MeasurementError.ShortRow, 2, 9)]
    [InlineData(ProbeOpen + "1.0 2.0 3.0 nan 0 0 0 0 0\n", MeasurementError.NotANumber, 2, 4)]
    [InlineData(ProbeOpen + "[PRB:1.000,2.000,3.000:1]\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("%\nP1 X1.0 Y2.0\nP1 X3.0 Y4.0\n%\n", MeasurementError.DuplicatePoint, 3, 1)]
    [InlineData("%\nP1 X1.0 Y2.0\nP2 X3.0\n%\n", MeasurementError.BadStructure, 3, 2)]
    [InlineData("%\nP1 X1.0 Y2.0\nP2 Y3.0 X4.0\n%\n", MeasurementError.BadStructure, 3, 3)]
    [InlineData("%\nP1 X1.0 Y2.0\nQ2 X3.0 Y4.0\n%\n", MeasurementError.BadStructure, 3, 3)]
    [InlineData("%\nP1 X1.0 Y2.0\nP2 X3.0 Y4.0 OK\n%\n", MeasurementError.BadStructure, 3, 1)]
    [InlineData("%\nP1 X1.0 Y2.0\n%\n%\nP2 X3.0 Y4.0\n%\n", MeasurementError.SeveralMeasurements, 5, 1)]
    [InlineData("%\nP1 X1.0000 Y2.0000\nP2 X3.0000 Y4.0", MeasurementError.ShortRow, 3, 3)]
    [InlineData("%\n1, 1.0, 2.0\n2, 3.0, 4.0, 5.0\n%\n", MeasurementError.BadStructure, 3, 4)]
    [InlineData("%\n1, 1.0, 2.0\n2.5, 3.0, 4.0\n%\n", MeasurementError.BadStructure, 3, 3)]
    [InlineData("G800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0\n", MeasurementError.BadStructure, 2, 5)]
    [InlineData("G800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N2 X0 Y3 Z0 R3.\n", MeasurementError.BadStructure, 2, 2)]
    [InlineData("G800 N1 X0 Y0 Z0 I0 J1 K0\nG800 N2 X0 Y3 Z0 I0 J1 K0\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("G800 N1 X0 Y0 Z0 I0 J1 K0\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("G800 N1 X0 Y0 Z0 I0 J1 K0.5\nG801 N1 X0 Y3 Z0 R3.\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("START\nG800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\n", MeasurementError.BadStructure, 3, 1)]
    [InlineData("START\nG800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\nSTART\n", MeasurementError.SeveralMeasurements, 4, 1)]
    [InlineData("G330 N1 A0. B-45. C0.\nG800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\n", MeasurementError.BadStructure, 1, 4)]
    [InlineData(
        "G800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\nG800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\n",
        MeasurementError.DuplicatePoint,
        4,
        2)]
    [InlineData(
        "G800 N1 X0 Y0 Z0 I0 J1 K0\nG801 N1 X0 Y3 Z0 R3.\nG800 N2 X0 Y0 Z0 I0 J-1 K0\nG801 N2 X0 Y3 Z0 R3.\n",
        MeasurementError.BadStructure,
        4,
        1)]
    [InlineData(
        "COMPONENT NO 1 FEATURE NO 1\nPOSN X1.0000 ACTUAL 1.0377 TOL 0.1 DEV -0.0377\n", MeasurementError.InconsistentDeviation, 2, 5)]
    [InlineData("COMPONENT NO 1 FEATURE NO 1\nPOSN X1.0000 ACTUAL 1.03\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("COMPONENT NO 1 FEATURE NO 1\nCOMPONENT NO 2 FEATURE NO 1\n", MeasurementError.SeveralMeasurements, 2, 1)]
    [InlineData("POSN X1.0000 ACTUAL 1.0 TOL 0.1 DEV 0.0\nCOMPONENT NO 2 FEATURE NO 1\n", MeasurementError.BadStructure, 1, 1)]
    [InlineData("COMPONENT NO 1 FEATURE NO 1\nP1 X1.0 Y2.0\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("CYCLE978 1 X Soll 1.0 Ist 1.1 Diff 0.1\nCYCLE978 1 X Soll 1.0 Ist 1.1 Diff 0.1\n", MeasurementError.DuplicatePoint, 2, 5)]
    [InlineData("CYCLE978 1 X Soll 1.0 Ist 1.1 Diff 0.1\nCYCLE978 1 Y Soll 1.0 Is\n", MeasurementError.BadStructure, 2, 1)]
    [InlineData("CYCLE978 1 X Soll 1.0 Ist 1.1 Diff 0.1\n", MeasurementError.MissingCoordinate, 1, 2)]
    public void A_log_that_cannot_be_used_is_named_by_code_line_and_column(string text, string code, int line, int column)
    {
        var error = Text.Refused(text);
        Assert.Equal((code, line, column), (error.Code, error.Place.Line, error.Place.Column));
        Assert.NotEmpty(error.Refusals[0].Expected);
    }

    [Fact]
    public void The_unit_is_the_logs_own_or_the_jobs()
    {
        var inch = MeasurementFormat.FromJson("""{ "unit": "inch" }""");
        Assert.Equal(25.4, Text.Read("[PRB:1.000,2.000,3.000:1]\n", inch).Points[0].Position.X);
        Assert.Equal(25.4, Text.Read("$13=1\n[PRB:1.000,2.000,3.000:1]\n").Points[0].Position.X);
        Assert.Equal(1, Text.Read("$13=0\n[PRB:1.000,2.000,3.000:1]\n", inch).Points[0].Position.X);
        Assert.Equal(25.4, Text.Read(ProbeOpen, inch).Points[0].Position.X);
        Assert.Equal(25.4, Text.Read("%\nP1 X1.0 Y2.0\n%\n", inch)["1"].Position.X);
        Assert.Equal(
            25.4 * 4, Text.Read("G800 N1 X4. Y0 Z0 I0 J1 K0\nG801 N1 X4. Y3 Z0 R3.\n", inch)["1"].Position.X, 12);
    }

    // The answer to $# repeats the last probing move, which is no second point.
    [Fact]
    public void A_repeated_answer_is_no_point()
    {
        const string Probe = "[PRB:1.000,2.000,3.000:1]\n";
        Assert.Single(Text.Read(Probe + "[TLO:0.000]\n" + Probe).Points);
        Assert.Equal(2, Text.Read(Probe + Probe).Points.Count);
    }

    [Fact]
    public void The_order_gives_names_and_both_numbers_are_named_where_they_differ()
    {
        var log = Text.Read(ProbeOpen + ProbeOpen);
        Assert.Equal(["B", "A"], log.InOrderOf(["B", "A"]).Points.Select(p => p.Label));
        Assert.Equal(2, log.InOrderOf(["B", "A"])["A"].Line);
        Assert.False(log.InOrderOf(["B", "A"]).IsByOrder);
        var error = Assert.Throws<InputException>(() => log.InOrderOf(["1", "2", "3"]));
        Assert.Equal(MeasurementError.PointCount, error.Code);
        Assert.Contains("2 points", error.Message, StringComparison.Ordinal);
        Assert.Contains("3, one for each", error.Message, StringComparison.Ordinal);
    }

    // The side of the nominal point on which the ball is tells which way the normal points.
    [Theory]
    [InlineData("I0. J1. K0.", "Y3.", 0)]
    [InlineData("I0. J-1. K0.", "Y3.", 0)]
    [InlineData("I0. J1. K0.", "Y0.1", 3.1)]
    [InlineData("I0. J1. K0.", "Y1.6", -1.4)]
    [InlineData("I0. J-1. K0.", "Y1.4", -1.6)]
    public void The_ball_of_a_results_file_is_a_radius_from_its_contact(string normal, string center, double contact) => Assert.Equal(
        contact, Text.Read($"G800 N1 X0 Y0 Z0 {normal}\nG801 N1 X0 {center} Z0 R3.\n")["1"].Position.Y, 12);

    [Theory]
    [MemberData(nameof(Names))]
    public void A_log_that_is_cut_off_is_read_up_to_a_line_or_named(string name)
    {
        var bytes = ControlLogs.Bytes(ControlLogs.All[name]);
        for (var length = 0; length < bytes.Length; length++)
        {
            if (Survives(bytes[..length]) is { } cut)
            {
                var whole = Text.Read(ControlLogs.All[name]);
                Assert.All(cut.Points, p => Assert.Equal(whole[p.Label].Position, p.Position));
            }
        }
    }

    [Fact]
    public void Random_bytes_are_read_or_named_and_nothing_else()
    {
        var random = new Random(31128);
        var (read, named) = (0, 0);
        var seeds = ControlLogs.All.Values.ToArray();
        for (var i = 0; i < 20_000; i++)
        {
            _ = Survives(MutationTests.Mutate(ControlLogs.Bytes(seeds[i % seeds.Length]), random)) is null ? named++ : read++;
        }

        Assert.True(read > 1000 && named > 4000, $"{read} read, {named} named");
    }

    [Fact]
    public void A_log_is_limited_in_size()
    {
        var big = new byte[(1 << 24) + 1];
        ControlLogs.Bytes(ProbeOpen).CopyTo(big, 0);
        Assert.Equal(
            MeasurementError.FileTooLarge,
            Assert.Throws<InputException>(() => MeasurementReader.Read(big, "log.txt", MeasurementFormat.Points)).Code);
        Assert.Equal(MeasurementError.BadStructure, Text.Refused("%\nP1 X1.0 Y" + new string('2', 1_000) + "\n").Code);
    }

    private static MeasurementFile? Survives(byte[] bytes)
    {
        try
        {
            var file = MeasurementReader.Read(bytes, "log.txt", MeasurementFormat.Points);
            Assert.All(file.Points, p => Assert.True(p.Position.IsFinite && p.Label.Length > 0 && p.Line > 0));
            return file;
        }
        catch (InputException e)
        {
            Assert.True(e.Place.Line >= 1 && e.Place.Column >= 1 && e.File == "log.txt" && e.Code.Length > 0, e.Message);
            Assert.DoesNotContain(e.Message, char.IsControl);
            return null;
        }
    }
}
