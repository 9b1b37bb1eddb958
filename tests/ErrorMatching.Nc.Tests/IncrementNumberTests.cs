namespace ErrorMatching.Nc.Tests;

/// <summary>Numbers without a point: read as the dialect says, displaced and written back in the same way, and noted.</summary>
public sealed class IncrementNumberTests
{
    private static readonly NcDialect Thousandths = OwnDialect.Of(Increments());

    private static readonly NcDialect TenThousandths = OwnDialect.Of(Increments(
        """, "metricDecimals": { "value": 4, "statement": "0.0001 mm.", "source": "our tests" } """));

    [Theory]
    [InlineData("X10000 Y5.", "R10,5,0")]
    [InlineData("X+10 Y-5", "R0.01,-0.005,0")]
    [InlineData("G20 X10000", "R25.4,0,0")]
    [InlineData("G1 X10000 F100\nG2 X20000 Y0 I5000 J0", "L10,0,0 CW20,0,0@15,0")]
    [InlineData("G1 X10000 F100\nG2 X20000 R5000", "L10,0,0 CW20,0,0@15,0")]
    [InlineData("G1 X10000 ,R2000 F100\nY10000", "L8,0,0 CCW10,2,0@8,2 L10,10,0")]
    [InlineData("G68 X0 Y0 R90000\nX10000 Y0", "R0,10,0")]
    [InlineData("G68 X0 Y0 R90.\nX10000 Y0", "R0,10,0")]
    [InlineData("G16\nX10000 Y90000", "R0,10,0")]
    [InlineData("G52 X1000\nX0", "R0,0,0")]
    [InlineData(
        "Z10000\nG99 G83 X1000 Z-5000 R2000 Q3000",
        "R0,0,10 R1,0,10 R1,0,2 L1,0,-1 R1,0,2 R1,0,-0.746 L1,0,-4 R1,0,2 R1,0,-3.746 L1,0,-5 R1,0,2")]
    public void Are_least_increments_where_the_dialect_says_so(string program, string moves) =>
        Assert.Equal(moves, Moves.Of(Bench.Read("G90 G17 G40 G0 X0 Y0 Z0\n" + program + "\n", Thousandths), 1));

    [Fact]
    public void Count_the_least_increment_that_the_dialect_states() =>
        Assert.Equal(new(10, -0.0005, 2), Bench.Read("G90 G0 X100000 Y-5 Z2.\n", TenThousandths).Motions[0].End);

    [Fact]
    public void Are_displaced_and_written_back_as_increments()
    {
        var result = Bench.Normal("G90 G17\nG0 X0 Y0\nN10 G1 X10000 F100\nN20 Y10.\nN30 X-5000\n", 0.1, "N10..N20", Thousandths);
        Assert.Equal("G90 G17\nG0 X0 Y100\nN10 G1 X9900 F100\nN20 Y10.\nN30 X-5000\n", result);
        var arc = Bench.Normal(
            "G90 G17\nG0 X0 Y0\nN10 G1 X10000 Y0 F100\nN20 G3 X15000 Y5000 I0 J5000\nN30 G1 X15000 Y20000\n",
            0.25,
            "N10..N30",
            Thousandths);
        Assert.Equal("G90 G17\nG0 X0 Y250\nN10 G1 X10000 Y250 F100\nN20 G3 X14750 Y5000 I0 J4750\nN30 G1 X14750 Y20000\n", arc);
        var finer = Bench.Normal("G90 G17\nG0 X0 Y0\nN10 G1 X100000 F100\nN20 Y100000\nN30 X-50000\n", 0.0123, "N10..N20", TenThousandths);
        Assert.Equal("G90 G17\nG0 X0 Y123\nN10 G1 X99877 F100\nN20 Y100000\nN30 X-50000\n", finer);
    }

    [Theory]
    [InlineData("fanuc", "X1 of 100")]
    [InlineData("delta-nc300", "X1 of 100")]
    [InlineData("generic", "X1 of 100")]
    [InlineData("siemens-840d", "")]
    [InlineData("linuxcnc", "")]
    public void Are_noted_where_machines_differ(string dialect, string noted)
    {
        // Zero is zero in any unit, and F, S, P and N have none that a point changes.
        var path = Bench.Read(
            "N1 G90 G17 G40 G0 X0 Y0 Z0.\nN2 G4 P500\nN3 G1 X10 Y5. F100 S2000\nN4 G2 X20 Y5. I5 J0\nN5 X30. Y5. R5\n",
            NcDialects.Named(dialect));
        Assert.Equal(
            noted.Length > 0 ? ("number-without-point", 2, 4L) : default,
            path.Notes.Select(n => (n.Code, n.Block, n.Count)).SingleOrDefault());
        Assert.All(
            path.Notes,
            n => Assert.Contains(
                "4 coordinates are written without a point, the first in N3. Dialect " + dialect
                    + " reads them in millimeters or inches: X100 is 100 mm.",
                n.Message,
                StringComparison.Ordinal));
    }

    [Fact]
    public void Are_always_noted_where_they_count_increments()
    {
        Assert.Contains(
            "in least increments: X100 is 0.1 mm.",
            Assert.Single(Bench.Read("G0 X5\n", Thousandths).Notes).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "in least increments: X100 is 0.01 mm.",
            Assert.Single(Bench.Read("G0 X5\n", TenThousandths).Notes).Message,
            StringComparison.Ordinal);
        Assert.Single(Bench.Read("G0 X5\n", OwnDialect.Of(Increments(), "linuxcnc")).Notes);
        Assert.Empty(Bench.Read("G0 X5. Y0\n", Thousandths).Notes);
    }

    private static string Increments(string more = "") =>
        """, "settings": { "integersAreIncrements": { "value": true, "statement": "X100 is 100 increments.", "source": "our tests" }"""
            + more + " }";
}
