using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Random counterparts whose programs are in Heidenhain Klartext: the rewritten program is cut by a referee that shares nothing with the
/// library, and what is left of the mating error must be the rounding of the program.
/// </summary>
public sealed class KlartextLoopTests
{
    private const double Rounding = 0.0015;
    private static readonly int Parts = Depth.Of(80, 200);

    /// <summary>Parts that may be refused: an arc to an angle follows a neighbor at its start, and its end cannot stay exactly.</summary>
    private const int AnglesAllowed = 3;

    [Fact]
    public void Both_referees_read_the_same_moves()
    {
        for (var seed = 0; seed < Parts; seed++)
        {
            var part = RandomParts.Generate(seed);
            var (iso, klartext) = (RefereeInterpreter.Run(part.Program), KlartextReferee.Run(KlartextWriter.InKlartext(part).Program));
            Assert.Equal(iso.Count + 1, klartext.Count);
            foreach (var (a, b) in iso.Zip(klartext.Skip(1)))
            {
                Assert.Equal((a.Block, a.Rapid, a.Side, a.IsArc), (b.Block, b.Rapid, b.Side, b.IsArc));
                Assert.InRange((a.To.In(WorkPlane.XY) - b.To.In(WorkPlane.XY)).Length, 0, seed % 4 == 3 ? 0.002 : 1e-9);
                Assert.Equal(a.To.Z, b.To.Z, 9);

                // A radius is rounded to micrometers.
                Assert.InRange(a.IsArc ? (a.Center - b.Center).Length + Math.Abs(a.Sweep - b.Sweep) : 0, 0, 0.002);
            }
        }
    }

    // The circle of a real tool, carried along the path of its center, leaves the contour that the referee reads.
    [Fact]
    public void The_tool_of_a_compensated_program_touches_the_programmed_contour()
    {
        var (failures, probed) = (new List<string>(), 0);
        for (var seed = 0; seed < Parts; seed++)
        {
            var part = KlartextWriter.InKlartext(RandomParts.Generate(seed));
            var radius = 0.5 + (seed % 3);
            var path = NcInterpreter.Run(NcProgram.FromText(part.Program, NcSyntax.Klartext), NcDialects.HeidenhainKlartext);
            var center = CompensatedPath.Of(path, ToolRadii.Of(radius), TestContext.Current.CancellationToken);
            if (!part.Flavor.Compensated || center.Refusal is not null)
            {
                continue;
            }

            var contour = KlartextReferee.Run(part.Program).Where(m => m.Side != CutterSide.None).ToList();
            var room = new VirtualCut(contour.Select(m => m with { Side = CutterSide.None }), radius - 1e-3);
            var (wanted, cut) = (new VirtualCut(contour, radius), new VirtualCut(center.Motions.Select(MoveOf), radius));
            foreach (var point in part.KeyPoints)
            {
                // In an inside corner the tool does not reach the point.
                var place = wanted.Probe(point.Place, point.Normal);
                if (room.Clearance(point.Place + (point.Normal.Unit() * (place + radius))) < 0)
                {
                    continue;
                }

                probed++;
                var error = cut.Probe(point.Place, point.Normal) - place;
                if (!(Math.Abs(error) <= Rounding))
                {
                    failures.Add($"part {seed}, {part.Flavor}, point {point.Label}: {error:0.0000} mm beside");
                }
            }
        }

        Assert.True(failures.Count == 0, string.Join('\n', failures));
        Assert.True(probed > Parts, $"{probed} points");
    }

    private static RefereeMove MoveOf(CompensatedMotion motion)
    {
        var (from, to) = (motion.Start, motion.End);
        var move = new RefereeMove(
            "", 0, motion.Kind == MotionKind.Rapid, new(from.X, from.Y, from.Z), new(to.X, to.Y, to.Z), WorkPlane.XY, CutterSide.None);
        return motion.IsArc ? move.Around(new(motion.Center.X, motion.Center.Y), motion.Kind == MotionKind.ArcCounterClockwise) : move;
    }

    [Fact]
    public void The_counterpart_follows_the_part()
    {
        var (failures, changed, angles) = (new List<string>(), 0, 0);
        for (var seed = 0; seed < Parts; seed++)
        {
            var original = RandomParts.Generate(seed);
            var part = KlartextWriter.InKlartext(original);
            var outcome = Matcher.Match(RandomMatch.FeedForward(part, NcDialects.HeidenhainKlartext.Name));
            if (outcome.Result is not { } result)
            {
                // What cannot follow the part in ISO cannot in Klartext.
                var refusal = outcome.Refusals[0];
                var isAngle = refusal.Code == NcRefusalCodes.ArcForm && part.Program.Contains("CP IPA", StringComparison.Ordinal);
                angles += isAngle ? 1 : 0;
                if (!isAngle
                    && (Matcher.Match(RandomMatch.FeedForward(original)).Refusals is not [var same] || same.Code != refusal.Code))
                {
                    failures.Add($"part {seed}, {part.Flavor}: {refusal.Message}");
                }

                continue;
            }

            var text = Encoding.ASCII.GetString(result.Program.Span);
            var marker = text.Split('\n')[1];
            Assert.True(marker.StartsWith("; ERRORMATCH MEASUREMENT=", StringComparison.Ordinal) && marker.EndsWith('\r'), marker);
            changed += text.Split("\r\n").Except(part.Program.Split("\r\n")).Count() > 1 ? 1 : 0;
            var cut = new VirtualCut(KlartextReferee.Run(text), part.ToolRadius);
            failures.AddRange(
                from feature in part.Features
                from point in feature.KeyPoints
                let error = cut.Probe(point.Place, point.Normal) - point.Deviation
                where !(Math.Abs(error) <= Rounding)
                select string.Create(
                    CultureInfo.InvariantCulture,
                    $"part {seed}, {part.Flavor}, {feature.Kind} {feature.Shape}, point {point.Label} (deviation "
                        + $"{point.Deviation:0.0000}): {error:0.0000} mm left"));
        }

        Assert.True(failures.Count == 0, string.Join('\n', failures));
        Assert.InRange(angles, 0, AnglesAllowed);
        Assert.InRange(changed, Parts - 4 - AnglesAllowed, Parts);
    }
}
