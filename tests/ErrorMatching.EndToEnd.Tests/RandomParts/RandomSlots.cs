using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Random slots and keys by number: cut either way round, their ends in one arc or two, begun within a flank or where it begins, with I
/// and J or R, G90 or G91, by the tool's center or under
/// cutter compensation, with straight or tangent ways in and out; and a part of another width, length, place and direction.
/// </summary>
internal static class RandomSlots
{
    /// <summary>The part of a number, zero or more.</summary>
    public static RandomPart Generate(int seed)
    {
        var random = new Random(seed);
        var isSlot = random.Next(2) == 0;
        var turn = random.Next(2) == 0 ? 1 : -1;
        var flavor = new Flavor(
            isSlot ? ContourKind.Pocket : ContourKind.Boss,
            isSlot != turn > 0,
            random.Next(2) == 0,
            random.Next(2) == 0,
            random.Next(3) == 0);
        var toolRadius = random.Next(2, 11) * 0.5;
        var radius = (isSlot ? (1.4 * toolRadius) + 1 : 1) + Draw.Between(random, 1, 12);
        var nominal = new Shape(
            new(Draw.Between(random, -100, 100), Draw.Between(random, -100, 100)),
            Draw.Between(random, -Math.PI, Math.PI),
            radius,
            Draw.Between(random, 6, 30),
            turn);
        var path = nominal with { Radius = flavor.Compensated ? radius : isSlot ? radius - toolRadius : radius + toolRadius };
        var part = nominal with
        {
            Middle = nominal.Middle + new Flat(Draw.Between(random, -0.05, 0.05), Draw.Between(random, -0.05, 0.05)),
            Heading = nominal.Heading + (Draw.Between(random, -0.04, 0.04) / nominal.Half),
            Radius = nominal.Radius + Draw.Signed(random, 0.01, 0.06),
            Half = nominal.Half + Draw.Between(random, -0.05, 0.05),
        };
        var frame = new RandomFrame(
            new[] { "none", "x", "y" }[random.Next(3)],
            Math.Round(Draw.Between(random, -180, 180), 3),
            new(Math.Round(Draw.Between(random, -120, 120), 3), Math.Round(Draw.Between(random, -120, 120), 3)));
        var (program, blocks) = Write(seed, random, flavor, path, isSlot);
        var feature = new RandomFeature("S1", "slot", isSlot ? "slot" : "key", blocks, KeyPoints(random, nominal, part, isSlot, frame));
        return new(seed, flavor, program, flavor.ToolOf(toolRadius), frame, [feature]);
    }

    private static (string Program, string Blocks) Write(int seed, Random random, Flavor flavor, Shape path, bool isSlot)
    {
        var writer = new ProgramWriter(flavor.RadiusArcs);
        foreach (var line in new[] { "%", $"O{(seed % 9000) + 1:0000}", $"(RANDOM SLOT {seed.ToString(CultureInfo.InvariantCulture)})" })
        {
            writer.Raw(line);
        }

        foreach (var words in new[] { "G21 G17 G40 G90", "G54", "T1 M6", "S6000 M3" })
        {
            writer.Words(words);
        }

        // Along the first flank, from its begin (-1) to its end (1).
        var begin = random.Next(3) == 0 ? -1 : Draw.Between(random, -0.5, 0.5);
        var (start, travel) = (path.OnFlank(1, begin), path.Along);
        var toTool = path.OutOfFlank(1) * (isSlot ? -1 : 1);
        var lead = random.Next(2) == 0 ? 0 : path.Radius * Draw.Between(random, 0.2, 0.4);
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
        var arcs = random.Next(1, 3);
        foreach (var side in new[] { 1, -1 })
        {
            Written(() => writer.Line(path.OnFlank(side, 1)));
            for (var i = 1; i <= arcs; i++)
            {
                Written(() => writer.Arc(new(path.OnEnd(side, (double)i / arcs), path.Center(side), path.Turn * Math.PI / arcs)));
            }
        }

        if (begin > -1)
        {
            Written(() => writer.Line(start));
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
        return (writer.Text, $"{blocks[0]}..{blocks[^1]}");

        void Written(Action write)
        {
            write();
            blocks.Add(writer.Block);
        }
    }

    private static List<IReadOnlyList<RandomKeyPoint>> KeyPoints(Random random, Shape nominal, Shape part, bool isSlot, RandomFrame frame)
    {
        var label = 0;
        var groups = new List<IReadOnlyList<RandomKeyPoint>>();
        foreach (var side in new[] { 1, -1 })
        {
            // Away from the middle of the flank, where the tool comes and goes, and from its ends.
            groups.Add([.. new[] { -0.8, 0.8 }.Select(share => Point(nominal.OnFlank(side, share), nominal.OutOfFlank(side)))]);
            var count = random.Next(1, 4);
            groups.Add(
                [
                    .. Enumerable.Range(1, count)
                        .Select(i => nominal.OnEnd(side, 0.15 + (0.7 * i / (count + 1))))
                        .Select(at => Point(at, (at - nominal.Center(side)).Unit()))]);
        }

        return groups;

        RandomKeyPoint Point(Flat at, Flat outward)
        {
            // How far out the part's boundary is: bisection of the distance from the line between the centers of its ends.
            var (low, high) = (-1.0, 1.0);
            for (var i = 0; i < 60; i++)
            {
                var middle = (low + high) / 2;
                (low, high) = part.DistanceFromAxis(at + (outward * middle)) < part.Radius ? (middle, high) : (low, middle);
            }

            label++;
            var (normal, deviation) = isSlot ? (-outward, -low) : (outward, low);
            return new(
                label.ToString(CultureInfo.InvariantCulture),
                at,
                normal,
                deviation,
                frame.ToPart(at),
                frame.ToPart(at + (normal * deviation)));
        }
    }

    /// <summary>Two flanks with round ends, travelled along the first flank (side 1) and back along the other (-1).</summary>
    private sealed record Shape(Flat Middle, double Heading, double Radius, double Half, int Turn)
    {
        public Flat Along => Flat.Toward(Heading);

        public Flat OutOfFlank(int side) => Along.Left * (-Turn * side);

        public Flat Center(int side) => Middle + (Along * (Half * side));

        public Flat OnFlank(int side, double share) => Middle + (Along * (Half * side * share)) + (OutOfFlank(side) * Radius);

        // The end behind that flank, from 0 to 1.
        public Flat OnEnd(int side, double share) =>
            Center(side) + (((OutOfFlank(side) * Math.Cos(Math.PI * share)) + (Along * (side * Math.Sin(Math.PI * share)))) * Radius);

        public double DistanceFromAxis(Flat place) =>
            (place - (Middle + (Along * Math.Clamp((place - Middle).Dot(Along), -Half, Half)))).Length;
    }
}
