using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Measurement.Tests;

public class PointsTests
{
    // Table 2 of Wang 2021, its first three points.
    private const string TableTwo = "point,x_mm,y_mm\n1,0.883,-2.819\n2,2.281,-8.381\n3,0.790,-15.772\n";

    [Fact]
    public void Points_keep_label_place_and_line()
    {
        var file = Text.Read(TableTwo);
        Assert.Equal(
            [
                new("1", new(0.883, -2.819, 0), false, 2),
                new("2", new(2.281, -8.381, 0), false, 3),
                new LabelledPoint("3", new(0.790, -15.772, 0), false, 4)],
            file.Points);
        Assert.Empty(file.Nominals);
        Assert.Equal("part.csv", file.File);
        Assert.Equal(LengthUnit.Millimeter, file.Unit);
    }

    [Fact]
    public void Provenance_is_the_sha_256_of_the_bytes() =>
        // printf 'point,x_mm,y_mm\nA,1,2\n' | sha256sum
        Assert.Equal("76cc61ded2906666a647376df8dcea1bf5d2876d874d5d34a288fe5db4781c15", Text.Read("point,x_mm,y_mm\nA,1,2\n").Sha256);

    [Fact]
    public void Z_is_read_where_the_file_has_it()
    {
        var point = Text.Read("point,x_mm,y_mm,z_mm\nA,1,2,-3.5\n")["A"];
        Assert.True(point.HasZ);
        Assert.Equal(new Point3(1, 2, -3.5), point.Position);
    }

    [Fact]
    public void Columns_may_stand_in_any_order_among_others() =>
        Assert.Equal(new Point3(1, 2, 0), Text.Read("Remark,Y_MM,point,X_mm\n\"a, b\",2,A,1\n")["A"].Position);

    [Theory]
    [InlineData("1", 1)]
    [InlineData("+1.", 1)]
    [InlineData("-.5", -0.5)]
    [InlineData(" 1.5e-3 ", 0.0015)]
    [InlineData("1E+2", 100)]
    [InlineData("-0", 0)]
    [InlineData("000012.5", 12.5)]
    [InlineData("0.1000000000000000055511151231257827", 0.1)]
    [InlineData("\"7.25\"", 7.25)]
    [InlineData("0e99999999999", 0)]
    public void Plain_decimals_are_read(string cell, double value) =>
        Assert.Equal(value, Text.Read($"point,x_mm,y_mm\nA,{cell},2\n")["A"].Position.X);

    // 25.4 times the decimal, rounded once: computed with Python's decimal and float.
    // The product of doubles gives 7.619999999999999 for the third.
    [Theory]
    [InlineData("1", 25.4)]
    [InlineData("1.1", 27.94)]
    [InlineData("0.3", 7.62)]
    [InlineData("-2.05", -52.07)]
    [InlineData("1.9685", 49.9999)]
    [InlineData("1e-3", 0.0254)]
    [InlineData("0.12345678901234567890123456789012345", 3.1358024409135803)]
    public void Inches_become_millimeters_with_one_rounding(string inches, double millimeters)
    {
        var file = Text.Read($"point,x_mm,y_mm\nA,{inches},0\n", Text.Format("""{ "unit": "inch" }"""));
        Assert.Equal(LengthUnit.Inch, file.Unit);
        Assert.Equal(millimeters, file["A"].Position.X);
    }

    [Fact]
    public void Asking_for_a_missing_point_names_point_and_file()
    {
        var file = Text.Read("note,point,x_mm,y_mm\n,a,1,2\n");
        file.Require(["a"]);
        Assert.False(file.TryGet("A", out _));
        var error = Assert.Throws<InputException>(() => file.Require(["a", "A"]));
        Assert.Equal((MeasurementError.MissingPoint, "part.csv", 1, 2), (error.Code, error.File, error.Place.Line, error.Place.Column));
        Assert.Contains("\"A\"", error.Message, StringComparison.Ordinal);
        Assert.Contains("(but \"a\")", error.Message, StringComparison.Ordinal);
        Assert.Equal(error.Message, Assert.Throws<InputException>(() => file["A"]).Message);
    }

    [Fact]
    public void A_message_has_place_finding_and_expectation() =>
        Assert.Equal(
            "part.csv, line 3, column 2: found \"1.2.3\" in column x_mm; expected a number such as 12.345 or -5e-3.",
            Text.Refused("point,x_mm,y_mm\nA,1,2\nB,1.2.3,4\n").Message);

    [Fact]
    public void Labels_do_not_depend_on_the_order_of_lines() =>
        Prop.ForAll(
            ArbMap.Default.ArbFor<int>(),
            seed =>
            {
                var lines = Enumerable.Range(1, 30).Select(i => FormattableString.Invariant($"P{i},{i * 0.37},{-i}")).ToArray();
                var shuffled = lines.ToArray();
                new Random(seed).Shuffle(shuffled);
                var (one, other) = (
                    Text.Read("point,x_mm,y_mm\n" + string.Join('\n', lines)),
                    Text.Read("point,x_mm,y_mm\n" + string.Join('\n', shuffled)));
                return one.Points.All(p => other[p.Label].Position == p.Position)
                    && other.Points.Select(p => p.Label).SequenceEqual(shuffled.Select(l => l.Split(',')[0]));
            }).QuickCheckThrowOnFailure();
}
