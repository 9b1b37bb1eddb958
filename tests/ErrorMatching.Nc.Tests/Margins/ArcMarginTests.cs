using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>How far the words of an arc may be off before the proof finds it, on both sides of each margin.</summary>
public sealed class ArcMarginTests
{
    private const string Radii = "N30: the radii at its start and end differ by more than a control accepts.";

    // The arc N30 goes with N20 by (0.1, 0.2). I is how far its center is aside, and how much shorter its radius is at its end.
    // Radii may differ by 1.5 increments, or by as much as before. The center goes along to 1e-6.
    [Theory]
    [InlineData(0.001, "I0.", "I0.")]
    [InlineData(0.001, "I0.", "I0.0000005")]
    [InlineData(0.001, "I0.", "I0.000002", "N30: it lies 0.0000 mm from where it was wanted.")]
    [InlineData(0.001, "I0.", "I0.0014", "N30: it lies 0.0014 mm from where it was wanted.")]
    [InlineData(0.001, "I0.", "I0.0016", Radii, "N30: it lies 0.0016 mm from where it was wanted.")]
    [InlineData(0.001, "I0.", "I0.005", Radii, "N30: it lies 0.0050 mm from where it was wanted.")]
    [InlineData(0.01, "I0.", "I0.009", "N30: it lies 0.0090 mm from where it was wanted.")]
    [InlineData(0.0001, "I0.", "I0.0009", "N30: it lies 0.0009 mm from where it was wanted.")]
    [InlineData(0.0001, "I0.", "I0.0011", Radii, "N30: it lies 0.0011 mm from where it was wanted.")]
    [InlineData(0.001, "I0.003", "I0.003")]
    [InlineData(0.001, "I0.003", "I0.0029", "N30: it lies 0.0001 mm from where it was wanted.")]
    [InlineData(0.001, "I0.003", "I0.0031", Radii, "N30: it lies 0.0001 mm from where it was wanted.")]
    public void Radii_differ_by_no_more_than_a_control_accepts(double increment, string was, string now, params string[] found)
    {
        var path = Bench.Read($"G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10. Y0. F100\nN30 G3 X15. Y5. {was} J5.\nG0 Z6.\nX50. Y0.\n");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N20..N30"), new(0.1, 0.2, 0)));
        var result = $"G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10.1 Y0.2 F100\nN30 G3 X15.1 Y5.2 {now} J5.\nG0 Z6.\nX50. Y0.\n";

        Assert.Equal(found, Messages(Prover.Check(path, NcProgram.FromText(result), wish, increment)));
    }

    // The increment is such that 1.5 of it and 1e-9 are 2^-9 mm: exactly the difference of the radii.
    [Fact]
    public void Radii_may_differ_by_the_limit_itself()
    {
        const double Increment = (0.001953125 - 1e-9) / 1.5;
        Assert.Equal(0.001953125, (1.5 * Increment) + 1e-9);
        var path = Bench.Read("G90 G17\nG0 X10. Y0. Z0.\nN30 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N30"), new(0, -0.001953125, 0)));
        var result = NcProgram.FromText("G90 G17\nG0 X10. Y0. Z0.\nN30 G3 X0. Y9.998046875 I-10. J0. F100\nG0 Z5.\n");

        Assert.Empty(Messages(Prover.Check(path, result, wish, Increment)));
    }

    // Ends that went apart by 1e-9 let the center go aside, for the arc turns a little then. From zero, the words say it exactly.
    [Theory]
    [InlineData("X0.000000001")]
    [InlineData("X0.0000000009", "N30: it lies 0.0000 mm from where it was wanted.")]
    public void An_arc_follows_as_a_whole_if_its_ends_went_alike_to_a_picometer(string end, params string[] found)
    {
        var path = Bench.Read("G90 G17\nG0 X10. Y0. Z0.\nN30 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N30"), new(1e-9, 0, 0)));
        var result = NcProgram.FromText($"G90 G17\nG0 X10. Y0. Z0.\nN30 G3 {end} Y10. I-10.00001 J0.00001 F100\nG0 Z5.\n");

        Assert.Equal(found, Messages(Prover.Check(path, result, wish, 0.001)));
    }

    // The arc begins at (-4, 0), ends at (4, 0) and is 2 high. Its start goes by 0.2 along its chord, so its top goes by 0.1.
    // The circle through (-3.8, 0), (0.1, 2) and (4, 0) is about (0.1, -2.8025). If its center is d higher, its top is 0.416 d higher.
    // 1.6 increments are allowed.
    [Theory]
    [InlineData("J-2.8025")]
    [InlineData("J-2.7989")]
    [InlineData("J-2.7984", "N30: it lies 0.0017 mm from where it was wanted.")]
    [InlineData("J-2.8061")]
    [InlineData("J-2.8066", "N30: it lies 0.0017 mm from where it was wanted.")]
    public void An_arc_with_one_moved_end_keeps_its_height(string center, params string[] found) =>
        Assert.Equal(found, WithMovedStart("I4. J-3.", $"I3.9 {center}"));

    // Nearly half a turn, 3.85 high: its radius is 4.002922 at first and (3.9^2 + 3.85^2) / 7.7 = 3.900325 at last. With the radius r, it
    // is r - sqrt(r^2 - 3.9^2) high: 3.8485 with 3.900345, 3.7801 with 3.9019. 1.6 increments are allowed, however it is written.
    [Theory]
    [InlineData("R3.900325")]
    [InlineData("R3.900345")]
    [InlineData("R3.900347", "N30: it lies 0.0017 mm from where it was wanted.")]
    [InlineData("R3.900302", "N30: it lies 0.0018 mm from where it was wanted.")]
    [InlineData("R3.9019", "N30: it lies 0.0699 mm from where it was wanted.")]
    public void An_arc_by_its_radius_is_as_high_as_one_by_its_center(string radius, params string[] found) =>
        Assert.Equal(found, WithMovedStart("R4.002922", radius));

    // Its radius is 5 at its start and sqrt(4.003^2 + 9) = 5.0024 at its end. The circle may be off by the difference in addition: with
    // 1.6 increments, 0.004. It is 2 high about (0.1015, -2.8054), and 0.416 d higher if its center is d higher.
    [Theory]
    [InlineData("J-2.8054")]
    [InlineData("J-2.7965")]
    [InlineData("J-2.795", "N30: it lies 0.0043 mm from where it was wanted.")]
    public void An_arc_may_be_off_by_the_difference_of_its_radii(string center, params string[] found) =>
        Assert.Equal(found, WithMovedStart("I4. J-3.", $"I3.9015 {center}", "X4.003"));

    // From a quarter of a turn to 179, 180 or 181 degrees.
    [Theory]
    [InlineData("X-10. Y0.", false)]
    [InlineData("X-9.998477 Y0.174524", false)]
    [InlineData("X-9.998477 Y-0.174524", true)]
    public void An_arc_may_turn_by_a_right_angle_more(string end, bool isFound)
    {
        var path = Bench.Read("G90 G17\nG0 X10. Y0. Z0.\nN30 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n");
        var result = Bench.Read($"G90 G17\nG0 X10. Y0. Z0.\nN30 G3 {end} I-10. J0. F100\nG0 Z5.\n");
        var motion = path.MotionOf(Bench.Blocks(path, "N30")[0]);
        var by = result.Motions[motion].End - path.Motions[motion].End;
        var proof = Prover.Check(path, result.Program, DisplacementWish.OfPoints([new(motion, by)]), 0.001);

        Assert.Equal(isFound, Messages(proof).Contains("N30: it turns by another angle than before."));
    }

    private static string[] WithMovedStart(string was, string now, string end = "X4.")
    {
        var path = Bench.Read($"G90 G17\nG0 X-10. Y0. Z0.\nN20 G1 X-4. Y0. F100\nN30 G2 {end} Y0. {was}\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N20"), new Vector3(0.2, 0, 0)));
        var result = $"G90 G17\nG0 X-10. Y0. Z0.\nN20 G1 X-3.8 Y0. F100\nN30 G2 {end} Y0. {now}\nG0 Z5.\n";
        return Messages(Prover.Check(path, NcProgram.FromText(result), wish, 0.001));
    }

    private static string[] Messages(NcProof proof) => [.. proof.Failures.Select(f => f.Message)];
}
