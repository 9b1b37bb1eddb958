using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Broken and hostile DXF files end in a message with file, place, finding and expectation.</summary>
public sealed class DxfHostileTests
{
    private static readonly string[] GoodLine = DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 3, 21, 0);

    [Fact]
    public void A_DWG_is_named()
    {
        var refused = DxfSample.Refused([.. "AC1032"u8, 0, 0, 0, 0, 1, 2, 3]);
        Assert.Equal("not-dxf", refused.Code);
        Assert.Contains("DWG", refused.Problem, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "the file is empty")]
    [InlineData("hello world\n", "\"hello world\"")]
    [InlineData("ISO-10303-21;\nHEADER;\n", "is this a DXF file?")]
    [InlineData("<svg>\n", "is this a DXF file?")]
    public void What_is_no_DXF_file_is_refused(string text, string expected)
    {
        var refused = DxfSample.Refused(Encoding.UTF8.GetBytes(text));
        Assert.Equal("not-dxf", refused.Code);
        Assert.Contains(expected, refused.Problem, StringComparison.Ordinal);
        Assert.Equal("part.dxf", refused.File);
    }

    [Fact]
    public void Text_in_UTF_16_is_named() =>
        Assert.Contains("UTF-16", DxfSample.Refused(Encoding.Unicode.GetPreamble()).Problem, StringComparison.Ordinal);

    [Fact]
    public void Each_cut_is_refused()
    {
        var text = DxfSample.Of(GoodLine).Unit(4).Text();
        for (var length = 0; length < text.Length - 2; length++)
        {
            var refused = DxfSample.Refused(Encoding.UTF8.GetBytes(text[..length]));
            Assert.True(refused.Code is "cut-off" or "not-dxf" or "bad-structure" or "bad-group", refused.Message);
        }
    }

    [Fact]
    public void Each_cut_of_a_binary_file_is_refused()
    {
        var bytes = DxfSample.Of(GoodLine).Unit(4).Binary(hasShortCodes: false);
        for (var length = 22; length < bytes.Length; length++)
        {
            var refused = DxfSample.Refused(bytes[..length]);
            Assert.True(refused.Code is "cut-off", refused.Message);
            Assert.Contains("byte ", refused.Problem, StringComparison.Ordinal);
            Assert.Null(refused.Place.Line);
        }
    }

    [Fact]
    public void A_missing_end_of_a_section_is_named()
    {
        var refused = DxfSample.Refused(Encoding.UTF8.GetBytes(
            DxfSample.Of(GoodLine).Unit(4).Text().Replace("  0\nENDSEC\n", "", StringComparison.Ordinal)));
        Assert.Equal("bad-structure", refused.Code);
        Assert.Equal(9, refused.Place.Line);
        Assert.Contains("ENDSEC", refused.Problem, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("NaN", "bad-value")]
    [InlineData("Infinity", "bad-value")]
    [InlineData("1e400", "bad-value")]
    [InlineData("1,5", "bad-value")]
    [InlineData("", "bad-value")]
    [InlineData("1e7", "too-large")]
    public void Bad_coordinates_are_named_with_entity_and_line(string number, string code)
    {
        var refused = DxfSample.Of("0 LINE", "8 0", "10 " + number, "20 0", "11 1", "21 1").Refused();
        Assert.Equal(code, refused.Code);
        Assert.Equal(code == "bad-value" ? 9 : 5, refused.Place.Line);
        Assert.Contains("LINE at line 5", refused.Problem, StringComparison.Ordinal);
        Assert.Contains("expected", refused.Problem, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0 LINE|8 0|10 1|20 1|11 2", "no group 21")]
    [InlineData("0 CIRCLE|8 0|10 1|20 1", "no group 40")]
    [InlineData("0 CIRCLE|8 0|10 1|20 1|40 -1", "a radius of -1")]
    [InlineData("0 CIRCLE|8 0|10 1|20 1|40 1|230 0", "extrusion direction without length")]
    [InlineData("0 ELLIPSE|8 0|10 1|20 1|11 1|21 0|40 -0.5", "axis ratio")]
    [InlineData("0 LWPOLYLINE|8 0|90 3|10 1|20 1|10 2|20 2", "2 vertices; group 90 says 3")]
    [InlineData("0 LWPOLYLINE|8 0|90 2|10 1|10 2|20 2", "out of order")]
    [InlineData("0 LWPOLYLINE|8 0|90 2|10 1|20 1|10 2", "out of order")]
    [InlineData("0 INSERT|8 0|2 NONE|10 0|20 0", "block \"NONE\", which the file does not have")]
    [InlineData("0 INSERT|8 0|10 0|20 0", "no name of a block")]
    [InlineData("0 VERTEX|8 0|10 0|20 0", "a POLYLINE before its VERTEX")]
    [InlineData("0 POLYLINE|8 0|0 VERTEX|10 0|20 0|0 LINE|8 0", "SEQEND")]
    public void Bad_entities_are_named(string groups, string problem)
    {
        var refused = DxfSample.Of(groups.Split('|')).Refused();
        Assert.Contains(problem, refused.Problem, StringComparison.Ordinal);
        Assert.NotNull(refused.Place.Line);
    }

    [Theory]
    [InlineData("71 3|40 0|40 0|40 0|40 0|40 1|40 1|40 1|10 0|20 0|10 1|20 0|10 1|20 1|10 2|20 2", "4 control points and 7 knots")]
    [InlineData("71 1|40 0|40 0|40 1|40 0.5|40 2|10 0|20 0|10 1|20 0|10 1|20 1", "knot 4 (0.5) after 1")]
    [InlineData("71 1|40 0|40 0|40 0|40 0|10 0|20 0|10 1|20 0", "all its knots are 0")]
    [InlineData("71 1|40 0|40 0|40 NaN|40 1|10 0|20 0|10 1|20 0", "\"NaN\" in group 40")]
    [InlineData("71 99|40 0|10 0|20 0", "degree 99")]
    [InlineData("71 0|40 0|10 0|20 0", "degree 0")]
    [InlineData("71 1|72 5|40 0|40 0|40 1|40 1|10 0|20 0|10 1|20 0", "4 knots; group 72 says 5")]
    [InlineData("71 1|73 3|40 0|40 0|40 1|40 1|10 0|20 0|10 1|20 0", "2 control points; group 73 says 3")]
    [InlineData("71 1|40 0|40 0|40 1|40 1|41 1|10 0|20 0|10 1|20 0", "1 weights for 2 control points")]
    [InlineData("71 1|40 0|40 0|40 1|40 1|41 1|41 0|10 0|20 0|10 1|20 0", "a weight of 0")]
    [InlineData("71 1|40 0|40 0|40 1|40 1|10 0|20 0|10 1", "coordinates")]
    [InlineData("71 3|11 0|21 0|11 1|21 0", "fit points without control points")]
    [InlineData("71 3", "no control points")]
    [InlineData("71 1|40 0|40 0|40 1|40 1|40 2|40 2|10 0|20 0|10 1|20 0|10 5|20 0|10 6|20 0", "pieces with a gap")]
    [InlineData("71 1|40 0|40 0|40 1|40 1|40 1|40 2|40 2|10 0|20 0|10 1|20 0|10 1|20 0|10 5|20 0|10 6|20 0", "more than 2 times")]
    public void Bad_splines_are_named(string groups, string problem)
    {
        var refused = DxfSample.Of(["0 SPLINE", "8 0", .. groups.Split('|')]).Refused();
        Assert.Contains(problem, refused.Problem, StringComparison.Ordinal);
        Assert.Contains("SPLINE at line 5", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Splines_that_overflow_end_soon()
    {
        foreach (var (pole, weight) in new[] { ("1e300", "1"), ("1e6", "1e-300"), ("1e5", "1e300"), ("1e5", "1e-200") })
        {
            var watch = Stopwatch.StartNew();
            ReadOrRefused(DxfSample.Of(
                "0 SPLINE", "8 0", "71 2", "40 0", "40 0", "40 0", "40 1", "40 1", "40 1", "41 1", "41 " + weight, "41 1",
                "10 0", "20 0", "10 " + pole, "20 5", "10 1", "20 " + pole).Bytes());
            Assert.True(watch.Elapsed < TimeSpan.FromSeconds(20), pole);
        }
    }

    [Fact]
    public void A_block_that_contains_itself_is_named()
    {
        var refused = DxfSample.Of([.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0), "2 A"])
            .Block("A", 0, 0, [.. DxfSample.Entity("INSERT", "0", 10, 1, 20, 0), "2 B"])
            .Block("B", 0, 0, [.. GoodLine, .. DxfSample.Entity("INSERT", "0", 10, 1, 20, 0), "2 a"])
            .Refused();
        Assert.Equal("bad-block", refused.Code);
        Assert.Contains("block \"A\" contains itself", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_bad_block_that_nobody_inserts_does_not_matter()
    {
        var drawing = DxfSample.Of(GoodLine).Block("A", 0, 0, "0 CIRCLE", "8 0", "10 x").Read();
        Assert.Single(drawing.Curves);
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(3000, 1)]
    public void Blocks_of_blocks_end_within_limits(int columns, int curves)
    {
        var sample = new DxfSample();
        for (var i = 0; i < 20; i++)
        {
            List<string> content = [];
            for (var k = 0; k < 4; k++)
            {
                content.AddRange(DxfSample.Entity("INSERT", "0", 10, k, 20, 0, 70, columns, 44, 1));
                content.Add(FormattableString.Invariant($"2 B{i + 1}"));
            }

            sample.Block(FormattableString.Invariant($"B{i}"), 0, 0, [.. content]);
        }

        sample.Block("B20", 0, 0, curves == 0 ? [] : GoodLine).Entities([.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0), "2 B0"]);
        var watch = Stopwatch.StartNew();
        var refused = sample.Refused();
        Assert.Equal("too-large", refused.Code);
        Assert.Contains(curves == 0 ? "INSERT at line" : "LINE at line", refused.Problem, StringComparison.Ordinal);
        Assert.True(watch.Elapsed < TimeSpan.FromSeconds(20));
    }

    [Theory]
    [InlineData(32767, 32767)]
    [InlineData(-1, 1)]
    [InlineData(2_000_000_000, 2_000_000_000)]
    [InlineData(700, 700)]
    public void Arrays_are_limited(int columns, int rows)
    {
        var refused = DxfSample.Of([.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0, 70, columns, 71, rows, 44, 1, 45, 1), "2 A"])
            .Block("A", 0, 0, GoodLine)
            .Refused();
        Assert.Equal("too-large", refused.Code);
    }

    [Fact]
    public void Deep_nesting_is_limited()
    {
        var sample = DxfSample.Of([.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0), "2 B0"]);
        for (var i = 0; i < 40; i++)
        {
            sample.Block(
                FormattableString.Invariant($"B{i}"), 0, 0,
                [.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0), FormattableString.Invariant($"2 B{i + 1}")]);
        }

        Assert.Contains("nested more than 32 deep", sample.Block("B40", 0, 0, GoodLine).Refused().Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_file_of_100_MB_is_refused_before_it_is_read()
    {
        var refused = DxfSample.Refused(new byte[100_000_000]);
        Assert.Equal("too-large", refused.Code);
        Assert.Contains("100000000 bytes", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Too_many_curves_are_refused()
    {
        var text = new StringBuilder("0\nSECTION\n2\nENTITIES\n");
        for (var i = 0; i <= DrawingLimits.MaxCurves; i++)
        {
            text.Append("0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n");
        }

        var refused = DxfSample.Refused(Encoding.UTF8.GetBytes(text.Append("0\nENDSEC\n0\nEOF\n").ToString()));
        Assert.Equal("too-large", refused.Code);
        Assert.Contains(" 200000 ", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Too_many_points_are_refused()
    {
        var ellipse = DxfSample.Entity("ELLIPSE", "0", 10, 0, 20, 0, 11, 9e5, 21, 0, 40, 0.5);
        var refused = DxfSample.Of([.. Enumerable.Repeat(ellipse, 100).SelectMany(e => e)]).Refused();
        Assert.Contains(" 2000000 ", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_drawing_of_hatches_alone_is_named()
    {
        var refused = DxfSample.Of([.. DxfSample.Entity("HATCH", "0"), .. DxfSample.Entity("HATCH", "0")]).Refused();
        Assert.Equal("no-curve", refused.Code);
        Assert.Contains("2 HATCH", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void Mutated_files_are_read_or_refused()
    {
        var sample = new DxfSample().Unit(1).Layer("A", flags: 1)
            .Block("B", 1, 2, [.. GoodLine, .. DxfSample.Entity("ARC", "0", 10, 0, 20, 0, 40, 1, 50, 0, 51, 90)])
            .Entities([
                .. GoodLine,
                .. DxfSample.Entity("LWPOLYLINE", "A", 90, 3, 70, 1, 10, 0, 20, 0, 42, 0.5, 10, 4, 20, 0, 10, 4, 20, 9),
                .. DxfSample.Entity("POLYLINE", "0", 66, 1, 70, 1),
                .. DxfSample.Entity("VERTEX", "0", 10, 0, 20, 0, 42, 1),
                .. DxfSample.Entity("VERTEX", "0", 10, 10, 20, 0),
                .. DxfSample.Entity("SEQEND", "0"),
                .. DxfSample.Entity("SPLINE", "0", 71, 2, 72, 6, 73, 3, 40, 0, 40, 0, 40, 0, 40, 1, 40, 1, 40, 1),
                "10 0", "20 0", "10 5", "20 9", "10 9", "20 0",
                .. DxfSample.Entity("INSERT", "0", 10, 7, 20, 7, 41, -2, 42, 1, 50, 30, 70, 2, 71, 2, 44, 5, 45, 5), "2 B",
                .. DxfSample.Entity("ELLIPSE", "0", 10, 1, 20, 1, 11, 2, 21, 1, 40, 0.5, 41, 0, 42, 3, 230, -1)]);
        var random = new Random(4711);
        byte[][] originals = [sample.Bytes(), sample.Binary(hasShortCodes: false), sample.Binary(hasShortCodes: true)];
        var (read, refused) = (0, 0);
        for (var i = 0; i < 6000; i++)
        {
            var bytes = (byte[])originals[i % 3].Clone();
            switch (random.Next(i % 3 == 0 ? 4 : 3))
            {
                case 0:
                    for (var k = random.Next(1, 4); k > 0; k--)
                    {
                        bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
                    }

                    break;
                case 1:
                    bytes = bytes[..random.Next(bytes.Length)];
                    break;
                case 2:
                    var (from, length) = (random.Next(bytes.Length - 30), random.Next(1, 30));
                    bytes = [.. bytes[..from], .. bytes[(from + length)..]];
                    break;
                default:
                    var lines = Encoding.Latin1.GetString(bytes).Split('\n');
                    var (a, b) = (random.Next(lines.Length), random.Next(lines.Length));
                    (lines[a], lines[b]) = (lines[b], lines[a]);
                    bytes = Encoding.Latin1.GetBytes(string.Join('\n', lines));
                    break;
            }

            if (ReadOrRefused(bytes))
            {
                read++;
            }
            else
            {
                refused++;
            }
        }

        Assert.True(read > 300 && refused > 300, string.Create(CultureInfo.InvariantCulture, $"{read} read, {refused} refused"));
    }

    // Nothing but a drawing of finite curves or a message with a place may come out.
    private static bool ReadOrRefused(byte[] bytes)
    {
        try
        {
            var drawing = DxfReader.Read(bytes, "part.dxf", null);
            Assert.NotEmpty(drawing.Curves);
            Assert.All(drawing.Curves, c => Assert.True(c.From.IsFinite && c.To.IsFinite));
            return true;
        }
        catch (InputException e)
        {
            Assert.Equal("part.dxf", e.File);
            Assert.NotEmpty(e.Problem);
            return false;
        }
    }
}
