using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs.Tests;

/// <summary>A part on a machine with a probe: a polygon of material, and a control that follows a probing program.</summary>
/// <remarks>It shares nothing with what plans and writes the program: distances are those to the edges of a polygon, a point is inside by
/// the number of edges beside it, and a touch is found by halving the measuring move.</remarks>
internal sealed class VirtualPart(IReadOnlyList<Point2> material, double stylusDiameterMm)
{
    /// <summary>Moves that went through the part, other than measuring moves.</summary>
    public List<string> Collisions { get; } = [];

    /// <summary>The centers of the ball where it touched, in the order of the program.</summary>
    public List<Point3> Touches { get; } = [];

    /// <summary>Follows a program below a height, over which there is nothing.</summary>
    public void Run(NcPath path, double topZ)
    {
        foreach (var motion in path.Motions)
        {
            if ((motion.UnknownStart | motion.UnknownEnd) != AxisSet.None)
            {
                continue;
            }

            if (motion.Kind == MotionKind.Probe)
            {
                Touches.Add(Touch(motion.Start, motion.End));
            }
            else
            {
                Move(motion.Start, motion.End, topZ, path.Program.NameOf(path.Program[motion.Block]));
            }
        }
    }

    /// <summary>Moves the ball, and notes where it meets the part.</summary>
    public void Move(Point3 from, Point3 to, double topZ, string block)
    {
        if (Enumerable.Range(0, 201).Select(k => from + ((to - from) * (k / 200.0)))
            .Any(p => p.Z < topZ && Room(new(p.X, p.Y)) < -1e-6))
        {
            Collisions.Add(block);
        }
    }

    /// <summary>What the built-in templates write to their log.</summary>
    public string Log(string plan, double noiseMm = 0, int seed = 1)
    {
        var random = new Random(seed);
        var text = new StringBuilder($"ERRORMATCH PROBE PLAN {plan} MM\n");
        for (var i = 0; i < Touches.Count; i++)
        {
            var (x, y) = (Touches[i].X + Noise(), Touches[i].Y + Noise());
            text.Append(CultureInfo.InvariantCulture, $"P{i + 1} C X{x:0.000000} Y{y:0.000000} Z{Touches[i].Z:0.000000}\n");
        }

        return text.Append("END\n").ToString();

        double Noise() => noiseMm * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }

    /// <summary>Between the ball and the part; negative where they overlap.</summary>
    public double Room(Point2 center)
    {
        var (distance, isInside) = (double.PositiveInfinity, false);
        for (var i = 0; i < material.Count; i++)
        {
            var (a, b) = (material[i], material[(i + 1) % material.Count]);
            var along = b - a;
            var t = Math.Clamp((center - a).Dot(along) / along.Dot(along), 0, 1);
            distance = Math.Min(distance, (center - (a + (along * t))).Length);
            if (a.Y > center.Y != b.Y > center.Y && center.X < a.X + ((center.Y - a.Y) / (b.Y - a.Y) * (b.X - a.X)))
            {
                isInside = !isInside;
            }
        }

        return (isInside ? -distance : distance) - (stylusDiameterMm / 2);
    }

    /// <summary>The center of the ball where a measuring move touches.</summary>
    public Point3 Touch(Point3 from, Point3 to)
    {
        Assert.True(Room(new(from.X, from.Y)) > 0, "The measuring move starts in the part.");
        Assert.True(Room(new(to.X, to.Y)) < 0, "The measuring move misses the part.");
        var (free, touched) = (0.0, 1.0);
        for (var k = 0; k < 60; k++)
        {
            var middle = (free + touched) / 2;
            var at = from + ((to - from) * middle);
            (free, touched) = Room(new(at.X, at.Y)) > 0 ? (middle, touched) : (free, middle);
        }

        return from + ((to - from) * free);
    }
}
