using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>What displaced elements do that part, that barely slide, and that lie at a place to which the path returns. Expected words are
/// worked out by hand.</summary>
public sealed class ApartTests
{
    private const string ThereAndBack =
        "N1 G21 G90 G17\nN2 G0 X0. Y0.\nN3 G1 X10. F100.\nN4 Y7.\nN5 Y0.\nN6 X15. Y4.\nN7 G0 Z5.\nM30\n";

    [Theory]
    [InlineData("N4", "N5")]
    [InlineData("N3", "N4", "N5")]
    public void A_reversal_is_named_as_one(params string[] named)
    {
        var refusal = Refusal(ThereAndBack, 0.02, named);
        Assert.Equal(NcRefusalCodes.NoIntersection, refusal.Code);
        Assert.Contains(" 180 degrees", refusal.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("amounts", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void One_of_the_two_can_be_displaced_and_the_other_follows() =>
        Assert.Equal(["N3 G1 X9.98 F100."], Changed(ThereAndBack, 0.02, "N4"));

    [Theory]
    [InlineData(0.02, 0.03, "(0.020 and 0.030 mm)")]
    [InlineData(0.02, 0.0205, "(0.020000 and 0.020500 mm)")]
    public void Amounts_that_are_said_to_differ_do_so_as_printed(double first, double second, string amounts)
    {
        var path = Bench.Read("G21 G90 G17\nN2 G0 X0. Y0.\nN3 G1 X10. F100.\nN4 X20.\nM30\n", NcDialects.Named("fanuc"));
        var wish = DisplacementWish.OfElements([Along(path, 2, first), Along(path, 3, second)]);
        var refusal = Bench.Refused(Rewriter.Apply(path, wish));
        Assert.Contains(amounts, refusal.Message, StringComparison.Ordinal);
    }

    // A program with four decimals has a least increment of 0.1 um. Two tangential pieces that differ by 0.3 um meet nowhere there, while
    // on a grid of 1 um nobody can tell them apart.
    [Theory]
    [InlineData("X10. Y0.", "X20. Y0.", true)]
    [InlineData("X10.0001 Y0.", "X20.0001 Y0.", false)]
    public void The_grid_of_the_program_says_what_is_alike(string first, string second, bool isAlike)
    {
        var path = Bench.Read($"G21 G90 G17\nN2 G0 X0. Y0.\nN3 G1 {first} F100.\nN4 {second}\nM30\n", NcDialects.Named("fanuc"));
        var wish = DisplacementWish.OfElements([Along(path, 2, 0.02), Along(path, 3, 0.0203)]);
        Assert.Equal(isAlike, Rewriter.Apply(path, wish).IsUsable);
    }

    // The lead-in arc ends at the bottom of its circle. Its end slides by 20 um, where the circle has risen by 0.2 um.
    [Fact]
    public void An_arc_whose_end_slides_keeps_its_center()
    {
        const string Program = "G21 G90 G17\nG0 X63.8489 Y258.6908\nG3 X64.7709 Y257.7689 I0.9220 J0.0000 F100.\nN4 G1 Y263.8863\n"
            + "N5 X70.\nN6 Y257.7689\nN7 X64.7709\nG0 Z5.\nM30\n";
        Assert.Equal("G3 X64.7909 Y257.7689 I0.9221 J0.0000 F100.", Changed(Program, -0.02, "N4")[0]);
    }

    // Displaced, N3 would meet N4 0.04 um before its end, which is nothing once it is rounded. So its end moves straight up instead.
    [Fact]
    public void A_neighbor_does_not_slide_down_to_nothing()
    {
        const string Program = "G21 G90 G17\nN2 G0 X0. Y0.\nN3 G1 X10. F100.\nN4 X10.1 Y0.1\nN5 X4. Y8.\nM30\n";
        Assert.Equal(["N2 G0 X0. Y0.1"], Changed(Program, 0.09997, "N3"));
    }

    // The second raster crosses the first, begins where its last line ends, and passes the start of its first line at its own end.
    [Theory]
    [InlineData("N40", "Positioning Positioning Slides")]
    [InlineData("N50", "Slides Slides")]
    [InlineData("N1050", "Slides Positioning")]
    [InlineData("N450", "Slides Slides")]
    public void Lines_of_a_raster_are_neighbors_only_of_the_lines_they_continue(string named, string roles)
    {
        var path = Bench.Read(TwoRasters(), NcDialects.LinuxCnc);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, named), 0.02));
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Empty(proof.Failures);
        Assert.Equal(roles, string.Join(' ', proof.Neighbors.Select(n => n.Role)));
    }

    [Theory]
    [InlineData("G1 X20. Y0.", "N20")]
    [InlineData("G3 X20. Y0. R10.", "N20")]
    public void A_contour_that_does_not_touch_itself_closes(string last, string closing)
    {
        var path = Bench.Read(
            $"G21 G90 G17\nG0 X20. Y0.\nN10 G1 X20. Y10. F100.\nN12 X0. Y10.\nN14 X0. Y0.\nN20 {last}\nG0 Z5.\nM30\n",
            NcDialects.Named("fanuc"));
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), -0.02));
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        Assert.Empty(proof.Failures);
        Assert.Contains(proof.Neighbors, n => n.Block == closing);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void Whatever_is_displaced_is_proved(int kind)
    {
        var displaced = 0;
        for (var seed = 0; seed < 60; seed++)
        {
            var random = new Random((100 * seed) + kind);
            var path = Bench.Read(RandomCuts(random, kind), NcDialects.LinuxCnc);
            int[] cuts = [.. Enumerable.Range(0, path.Motions.Length).Where(i => path.Motions[i] is { IsCut: true, MovesInPlane: true })];
            for (var trial = 0; trial < 4; trial++)
            {
                var count = Math.Min(cuts.Length, 1 + random.Next(20));
                var from = random.Next(cuts.Length - count + 1);
                var wish = Bench.Usable(DisplacementWish.Normal(
                    path,
                    [.. cuts.Skip(from).Take(count).Select(i => path.Motions[i].Block).Distinct()],
                    0.1 * (random.NextDouble() - 0.5)));
                if (Rewriter.Apply(path, wish).Result is { } rewrite)
                {
                    displaced++;
                    Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
                }
            }
        }

        Assert.True(displaced > 20, $"Only {displaced} of 240 wishes could be met.");
    }

    // 0: a curve of short chords with four decimals. 1: lines and tangent arcs. 2: strokes there and back.
    private static string RandomCuts(Random random, int kind)
    {
        var text = new StringBuilder("G21 G90 G17 G40 G91.1\nG0 X0 Y0\nG1 Z-1 F100\n");
        var (x, y, heading) = (0.0, 0.0, 0.0);
        for (var k = 0; k < 30; k++)
        {
            if (kind == 1 && random.Next(2) == 0)
            {
                var (radius, sweep) = (0.1 + (random.NextDouble() * 5), 0.1 + (random.NextDouble() * 1.8));
                var sign = random.Next(2) == 0 ? -1 : 1;
                var (cx, cy) = (x - (sign * radius * Math.Sin(heading)), y + (sign * radius * Math.Cos(heading)));
                heading += sign * sweep;
                var (toX, toY) = (cx + (sign * radius * Math.Sin(heading)), cy - (sign * radius * Math.Cos(heading)));
                Put(sign < 0 ? "G2" : "G3", toX, toY, (cx - x, cy - y));
                continue;
            }

            heading += kind switch
            {
                0 => (random.NextDouble() - 0.5) * 0.6,
                1 => random.Next(4) == 0 ? (random.NextDouble() - 0.5) * 3 : 0,
                _ => random.Next(3) == 0 ? Math.PI : (random.NextDouble() - 0.5) * 2,
            };
            var length = kind == 0 ? 0.05 + (random.NextDouble() * 0.6) : 0.5 + (random.NextDouble() * 5);
            Put("G1", x + (length * Math.Cos(heading)), y + (length * Math.Sin(heading)), null);
        }

        return text.Append("G0 Z5\nM2\n").ToString();

        void Put(string code, double endX, double endY, (double I, double J)? center)
        {
            (x, y) = (Math.Round(endX, 4), Math.Round(endY, 4));
            var words = center is var (i, j) ? FormattableString.Invariant($" I{i:0.0000} J{j:0.0000}") : "";
            text.Append(CultureInfo.InvariantCulture, $"{code} X{x:0.####} Y{y:0.####}{words}\n");
        }
    }

    private static string TwoRasters()
    {
        var (text, number) = (new StringBuilder(), 10);
        Put("G21 G90 G17 G40");
        Put("G0 X0 Y0 Z5");
        Put("G1 Z-1 F100");
        for (var i = 0; i <= 20; i++)
        {
            Put($"G1 X{(i % 2 == 0 ? 30 : 0)} Y{i}");
            Put(i < 20 ? $"G1 Y{i + 1}" : "G1 X30 Y0");
        }

        for (var j = 1; j <= 30; j++)
        {
            Put($"G1 X{30 - j}");
            Put($"G1 X{30 - j} Y{(j % 2 == 0 ? 0 : 20)}");
        }

        Put("G0 Z5");
        return text.Append("M2\n").ToString();

        void Put(string block)
        {
            text.Append(CultureInfo.InvariantCulture, $"N{number} {block}\n");
            number += 10;
        }
    }

    private static ElementWish Along(NcPath path, int block, double left) =>
        ElementWish.AlongNormals(path, path.MotionOf(block), left, left, left);

    private static Refusals.Refusal Refusal(string program, double left, params string[] named)
    {
        var path = Bench.Read(program, NcDialects.Named("fanuc"));
        return Bench.Refused(Rewriter.Apply(path, Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, named), left))));
    }

    private static string[] Changed(string program, double left, params string[] named)
    {
        var path = Bench.Read(program, NcDialects.Named("linuxcnc"));
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, named), left));
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        Assert.Empty(Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm).Failures);
        return [
            .. Encoding.Latin1.GetString(rewrite.Program.Bytes.Span).Split('\n').Zip(program.Split('\n'))
                .Where(p => p.First != p.Second).Select(p => p.First)];
    }
}
