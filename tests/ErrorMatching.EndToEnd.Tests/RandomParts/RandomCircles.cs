using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Random bores and bosses by number: one to four arcs, cut either way round, with I and J or R, G90 or G91, by the tool's center or
/// under cutter compensation, with straight or
/// tangent ways in and out; and a part whose circle has another center and another radius.
/// </summary>
internal static class RandomCircles
{
    // Key points stay away from the place where the tool comes and goes, degrees.
    private const double Margin = 20;

    private static readonly string[] Methods = ["least-squares", "inscribed", "circumscribed"];

    /// <summary>The part of a number, zero or more.</summary>
    public static RandomPart Generate(int seed)
    {
        var random = new Random(seed);
        var isBore = random.Next(2) == 0;
        var isLeftTurn = random.Next(2) == 0;

        // Travelling counter-clockwise the center is on the left: the material of a boss.
        var flavor = new Flavor(
            isBore ? ContourKind.Pocket : ContourKind.Boss,
            isBore != isLeftTurn,
            random.Next(2) == 0,
            random.Next(2) == 0,
            random.Next(3) == 0);
        var toolRadius = random.Next(2, 11) * 0.5;
        var boundary = (isBore ? (1.4 * toolRadius) + 1 : 1) + Draw.Between(random, 1, 25);
        var center = new Flat(Draw.Between(random, -100, 100), Draw.Between(random, -100, 100));
        var path = new Ring(
            center,
            flavor.Compensated ? boundary : isBore ? boundary - toolRadius : boundary + toolRadius,
            Draw.Between(random, -Math.PI, Math.PI),
            isLeftTurn ? 1 : -1,
            isBore);
        var frame = new RandomFrame(
            new[] { "none", "x", "y" }[random.Next(3)],
            Math.Round(Draw.Between(random, -180, 180), 3),
            new(Math.Round(Draw.Between(random, -120, 120), 3), Math.Round(Draw.Between(random, -120, 120), 3)));
        var (program, blocks) = Write(seed, random, flavor, path);
        var feature = new RandomFeature("B1", "circle", isBore ? "bore" : "boss", blocks, [KeyPoints(random, path, boundary, frame)])
        {
            More = $", \"method\": \"{Methods[seed % Methods.Length]}\"",
        };
        return new(seed, flavor, program, flavor.ToolOf(toolRadius), frame, [feature]);
    }

    private static (string Program, string Blocks) Write(int seed, Random random, Flavor flavor, Ring path)
    {
        var writer = new ProgramWriter(flavor.RadiusArcs);
        foreach (var line in new[] { "%", $"O{(seed % 9000) + 1:0000}", $"(RANDOM CIRCLE {seed.ToString(CultureInfo.InvariantCulture)})" })
        {
            writer.Raw(line);
        }

        foreach (var words in new[] { "G21 G17 G40 G90", "G54", "T1 M6", "S6000 M3" })
        {
            writer.Words(words);
        }

        var lead = random.Next(2) == 0 ? 0 : path.Radius * Draw.Between(random, 0.2, 0.4);
        var (start, toTool, travel) = (path.At(0), path.ToTool(0), path.Travel(0));
        var away = path.Radius * Draw.Between(random, 0.2, 0.5);
        writer.Line(lead > 0 ? start + (toTool * (lead * 1.3)) - (travel * lead) : start + (toTool * away), motion: 0);
        writer.Words("G43 H1 Z5.");
        writer.Plunge();
        if (flavor.Incremental)
        {
            writer.Words("G91");
            writer.Incremental = true;
        }

        writer.Line(
            lead > 0 ? start + ((toTool - travel) * lead) : start,
            before: !flavor.Compensated ? "" : flavor.MaterialLeft ? "G42 D1" : "G41 D1",
            after: "F500.");
        var quarter = Math.Sign(travel.Cross(toTool)) * Math.PI / 2;
        if (lead > 0)
        {
            writer.Arc(new(start, start + (toTool * lead), quarter));
        }

        var blocks = new List<string>();

        // The center of an arc by its R is the less certain the nearer it is to half a turn: these are thirds and quarters.
        var count = flavor.RadiusArcs ? random.Next(3, 5) : random.Next(1, 5);
        var uneven = flavor.RadiusArcs ? 0.05 : 0.3;
        double[] cuts = [0, .. Enumerable.Range(1, count - 1).Select(i => (i + Draw.Between(random, -uneven, uneven)) / count), 1];
        foreach (var (from, to) in cuts.Zip(cuts.Skip(1)))
        {
            writer.Arc(new(to == 1 ? start : path.At(to), path.Center, path.Turn * 2 * Math.PI * (to - from)));
            blocks.Add(writer.Block);
        }

        if (lead > 0)
        {
            writer.Arc(new(start + ((toTool + travel) * lead), start + (toTool * lead), quarter));
        }

        writer.Line(
            lead > 0 ? start + (toTool * (lead * 1.3)) + (travel * lead) : start + (toTool * away),
            before: flavor.Compensated ? "G40" : "");
        writer.Words("G90 G0 Z50.");
        writer.Words("M30");
        writer.Raw("%");
        return (writer.Text, blocks.Count == 1 ? blocks[0] : $"{blocks[0]}..{blocks[^1]}");
    }

    private static List<RandomKeyPoint> KeyPoints(Random random, Ring path, double boundary, RandomFrame frame)
    {
        var count = random.Next(5, 13);
        var shift = new Flat(Draw.Between(random, -0.05, 0.05), Draw.Between(random, -0.05, 0.05));
        var radius = boundary + Draw.Signed(random, 0.01, 0.08);
        var first = random.Next(count);
        return [.. Enumerable.Range(0, count).Select(i =>
        {
            // Named from anywhere on, in the order of cutting.
            var place = ((first + i) % count / (count - 1.0) * (360 - (2 * Margin))) + Margin;
            var spoke = (path.At(place / 360) - path.Center).Unit();
            var across = shift.Cross(spoke);
            var outward = shift.Dot(spoke) + Math.Sqrt((radius * radius) - (across * across)) - boundary;
            var (at, normal) = (path.Center + (spoke * boundary), path.IsBore ? -spoke : spoke);
            var deviation = path.IsBore ? -outward : outward;
            return new RandomKeyPoint(
                (i + 1).ToString(CultureInfo.InvariantCulture),
                at,
                normal,
                deviation,
                frame.ToPart(at),
                frame.ToPart(at + (normal * deviation)));
        })];
    }

    /// <summary>The circle of the path, from where the tool comes to it once round.</summary>
    private sealed record Ring(Flat Center, double Radius, double From, int Turn, bool IsBore)
    {
        public Flat At(double share) => Center + (Spoke(share) * Radius);

        public Flat ToTool(double share) => IsBore ? -Spoke(share) : Spoke(share);

        public Flat Travel(double share) => Turn > 0 ? Spoke(share).Left : -Spoke(share).Left;

        private Flat Spoke(double share) => Flat.Toward(From + (Turn * 2 * Math.PI * share));
    }
}
