using System.Reflection;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>What cannot be changed safely is refused, with the block, its line and a reason that says what to do.</summary>
public sealed class RefusalTests
{
    private const string Head = "G90 G17 G21 G40\nG0 X0. Y0. Z0.\n";

    public static TheoryData<string, string, string, int, string> Normals => new()
    {
        { NcRefusalCodes.NoMotion, "N10 M8\n", "N10", 3, "N10" },
        { NcRefusalCodes.NoMotion, "N10 G0 X5.\n", "N10", 3, "N10" },
        { NcRefusalCodes.Expression, "N10 G1 X#100 F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.Expression, "N10 G1 X10. F100\nN20 G2 X20. I[2+3] J0.\n", "N20", 4, "N20" },
        { NcRefusalCodes.UnknownWord, "N10 G1 X10. E5 F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.UnknownWord, "N10 G1 X10. X11. F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.ActiveTransform, "G68 X0. Y0. R30.\nN10 G1 X10. F100\n", "N10", 4, "N10" },
        { NcRefusalCodes.OtherAxis, "N10 G1 X10. A5. F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.UnknownState, "G187\nN10 G1 X10. F100\n", "N10", 4, "N10" },
        { NcRefusalCodes.UnknownState, "G187\nX1. Y1. Z1.\nN10 G1 X10. F100\n", "N10", 5, "N10" },
        { NcRefusalCodes.UnknownState, "G55\nN10 G1 X10. F100\n", "N10", 4, "N10" },
        { NcRefusalCodes.EndlessLoop, "N10 G1 X10. F100\nN20 GOTO 10\n", "N10", 4, "N20" },
        { NcRefusalCodes.FrameChange, "N10 G1 X10. F100\nG92 X0. Y0.\nN30 G1 Y10.\n", "N10", 4, "line 4" },
        { NcRefusalCodes.MissingProgram, "N10 G1 X10. F100\nM98 P7\nG90 G17 G40 G0 X0. Y0. Z0.\n", "N10", 4, "line 4" },
        { NcRefusalCodes.FrameChange, "N10 G1 X10. F100\nG92 X0. Y0.\nG0 X5. Y5.\n", "N10", 4, "line 4" },
        { NcRefusalCodes.BadArc, "N10 G2 X10. Y0. I3. J0. F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.ElementFlips, "N10 G1 X10. F100\nN20 G3 X10. Y0.2 I0. J0.1\nN30 G1 X0. Y0.2\n", "N10..N30", 4, "N20" },
        { NcRefusalCodes.NoIntersection, "N10 G1 X10. F100\nN20 X-10. Y0.001\n", "N10..N20", 4, "N20" },
        { NcRefusalCodes.CornerWord, "N10 G1 X10. ,R2. F100\nN20 Y10.\n", "N10..N20", 3, "N10" },
        { NcRefusalCodes.PlaneChange, "N10 G1 X10. Z0. F100\nG18\nN20 G1 X20. Z5.\n", "N10..N20", 5, "N20" },
        { NcRefusalCodes.NotASimpleMove, "G91\nN10 G1 X10. F100\nN20 G81 X5. Y5. Z-5. R2.\n", "N10", 5, "N20" },
        { NcRefusalCodes.UnknownState, "N10 G1 X10. F100\nG20\nN20 X0. Y2.\n", "N10..N20", 5, "N20" },
        { NcRefusalCodes.UnknownState, "G187 X5.\nG1 G90 G17 G40 X0. F100\nN10 G1 X10.\n", "N10", 5, "N10" },
        { NcRefusalCodes.UnknownWord, "N10 G187 G90 G17 G40 G1 X10. Y0. Z0. F100\n", "N10", 3, "N10" },

        { NcRefusalCodes.NoPositioning, "N10 G1 X10. F100\nG0 Z5.\nG1 Z-1.\nN20 X20. Y10.\n", "N10", 6, "N20" },

        // From one unknown place to another: not to be left out in silence.
        { NcRefusalCodes.UnknownState, "G55\nG91\nN10 G1 X10. F100\nG90 G0 X0. Y0. Z0.\nN20 G1 X10.\n", "N10..N20", 5, "N10" },
        { NcRefusalCodes.Expression, "G55\nN10 G1 X#1000 Y#1001 F100\nG0 X0. Y0. Z0.\nN20 G1 X10.\n", "N10..N20", 4, "N10" },

        // The entry from (0, 0.6) would be 0.1 long.
        { NcRefusalCodes.CompensationEntry, "G0 Y0.6\nG41 D1 G1 Y0. F100\nN10 X10.\nN20 Y-10.\n", "N10", 4, "line 4" },

        // The subprogram's block is entered square at its first run and at another angle at its second.
        { NcRefusalCodes.RunsDiffer, "G1 Y5. F100\nM98 P7\nG1 X20. Y10.\nM98 P7\nM30\nO7\nN10 G91 G1 X10.\nG90\nM99\n", "N10", 9, "N10" },
    };

    public static TheoryData<string, string, string, int, string> SiemensNormals => new()
    {
        { NcRefusalCodes.ArcForm, "N10 G3 X10 Y0 AR=90 F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.ArcForm, "N10 CIP X10 Y0 I1=5 J1=5 F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.ArcForm, "N10 G1 X10 F100\nN20 CT X15 Y5\n", "N10..N20", 4, "N20" },
        { NcRefusalCodes.ActiveTransform, "TRAORI\nN10 G1 X10 Y0 Z0 F100\n", "N10", 4, "N10" },
        { NcRefusalCodes.CornerWord, "N10 G1 X10 RND=2 F100\nN20 Y10\n", "N20", 3, "N10" },
    };

    public static TheoryData<string, string, string, int, string> EndPoints => new()
    {
        { NcRefusalCodes.NoMotion, "N10 M8\n", "N10", 3, "N10" },
        { NcRefusalCodes.NotASimpleMove, "N10 G28 Z0.\n", "N10", 3, "N10" },
        { NcRefusalCodes.NotASimpleMove, "N10 G53 G0 X0.\n", "N10", 3, "N10" },
        { NcRefusalCodes.NotASimpleMove, "N10 G81 X5. Y5. Z-5. R2. F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.ElementFlips, "N10 G3 I-10. F100\n", "N10", 3, "N10" },
        { NcRefusalCodes.UnknownState, "G55 G90\nN10 G0 Z5.\n", "N10", 4, "N10" },

        // Eighteen digits are exact: fifteen and three decimals are one too many above nine hundred billions.
        { NcRefusalCodes.NumberTooLong, "N10 G1 X999999999999999. F100\n", "N10", 3, "N10" },
    };

    [Theory]
    [MemberData(nameof(Normals))]
    public void Displaced_elements_are_refused(string code, string program, string named, int line, string block) =>
        AssertRefusal(code, line, block, Bench.RefusedNormal(Head + program, 0.5, named));

    [Theory]
    [MemberData(nameof(SiemensNormals))]
    public void Displaced_elements_of_Siemens_are_refused(string code, string program, string named, int line, string block) =>
        AssertRefusal(
            code, line, block, Bench.RefusedNormal("G90 G17 G71 G40\nG0 X0 Y0 Z0\n" + program, 0.5, named, NcDialects.Siemens840D));

    [Theory]
    [MemberData(nameof(EndPoints))]
    public void Moved_end_points_are_refused(string code, string program, string named, int line, string block) =>
        AssertRefusal(code, line, block, Bench.RefusedBy(Head + program, new Vector3(0.5, 0.25, 0), named));

    [Fact]
    public void Tangent_elements_that_move_differently_are_refused_with_both_amounts()
    {
        var path = Bench.Read(Head + "N10 G1 X10. Y0. F100\nN20 X20. Y0.\n");
        var refusal = Bench.Refused(Rewriter.Apply(
            path,
            DisplacementWish.OfElements(
                [ElementWish.AlongNormals(path, 1, 0.1, 0.1, 0.1), ElementWish.AlongNormals(path, 2, 0.2, 0.2, 0.2)])));
        AssertRefusal(NcRefusalCodes.NoIntersection, 4, "N20", refusal);
        Assert.Contains("0.100 and 0.200 mm", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Nothing_named_is_refused() =>
        Assert.Equal(NcRefusalCodes.NoMotion, Bench.Refused(DisplacementWish.Normal(Bench.Read(Head), [], 1)).Code);

    [Fact]
    public void Two_wishes_for_one_motion_are_an_error() =>
        Assert.Throws<ArgumentException>(() => DisplacementWish.OfElements(
            [new(1, default, default, default), new(1, default, default, default)]));

    [Fact]
    public void Every_code_has_a_test_here_or_with_selectors_points_flow_or_the_proof()
    {
        string[] elsewhere =
        [
            NcRefusalCodes.BlockNotFound, NcRefusalCodes.BlockAmbiguous, NcRefusalCodes.PointOffPath, NcRefusalCodes.RunWithoutPoint,
            NcRefusalCodes.PointsCoincide, NcRefusalCodes.ProofFailed,
            NcRefusalCodes.EndlessLoop, NcRefusalCodes.MissingProgram, NcRefusalCodes.MissingLabel, NcRefusalCodes.UnknownCondition,
            NcRefusalCodes.BadExpression, NcRefusalCodes.CallTooDeep,
            NcRefusalCodes.BlockSkip,
            NcRefusalCodes.CompensationGouge, NcRefusalCodes.CompensationStop, NcRefusalCodes.CompensationUnfollowed,
            NcRefusalCodes.ToolRadiusUnknown, NcRefusalCodes.RefusedByControl,
        ];
        var codes = typeof(NcRefusalCodes).GetFields(
            BindingFlags.Public | BindingFlags.Static).Select(f => (string)f.GetRawConstantValue()!);
        Assert.Equal(
            codes.Order(StringComparer.Ordinal),
            Normals.Concat(SiemensNormals)
                .Select(r => r.Data.Item1)
                .Concat(EndPoints.Select(r => r.Data.Item1))
                .Concat(elsewhere)
                .Distinct()
                .Order(StringComparer.Ordinal));
    }

    private static void AssertRefusal(string code, int line, string block, Refusal refusal)
    {
        Assert.Equal((code, block, line), (refusal.Code, refusal.Place.Block, refusal.Place.Line));
        Assert.StartsWith(block + ": ", refusal.Message, StringComparison.Ordinal);
        Assert.EndsWith(".", refusal.Message, StringComparison.Ordinal);
    }
}
