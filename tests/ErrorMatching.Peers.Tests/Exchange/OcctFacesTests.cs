using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Flat faces of plates that the CAD kernel builds and writes as STEP: their edges are the curves they were built of.</summary>
public sealed class OcctFacesTests
{
    // It writes 13 digits.
    private const double Mm = 1e-9;

    // 60 mm between the centers of two round ends of radius 15, from z = 3 to 10, with an elliptic hole of half axes 9 and 4.
    private const string Plate = """
        profile p O 0 0 3 X 60 C 15 180 X -60 C 15 180
        prism s p 0 0 7
        ellipse c 30 15 -5 0 0 1 9 4
        mkedge e c
        wire w e
        mkplane f w
        prism h f 0 0 30
        bcut q s h

        """;

    [Theory]
    [InlineData("MM", 1)]
    [InlineData("INCH", 25.4)]
    public void Edges_of_a_plate_are_the_curves_it_was_built_of(string unit, double unitMm)
    {
        OcctDraw.IsNeeded();
        var faces = Read(Plate, unit);
        Assert.Equal(unitMm, faces.UnitMm);
        FlatFace[] level = [.. faces.Faces.Where(f => Math.Abs(f.Normal.Z) > 1 - 1e-12)];
        Assert.Equal([3, 10], level.Select(f => Math.Round(f.Origin.Z, 9)).Order());
        Assert.Equal(4, faces.Faces.Count);
        foreach (var face in level)
        {
            var bounds = face.ReadBounds();
            Assert.Equal([1, 4], bounds.Select(b => b.Count).Order());
            var hole = bounds.Single(b => b.Count == 1)[0];

            // The kernel intersects the plane with the wall of the hole, within its own tolerance of 1e-7 mm.
            Assert.All(PointsOf(hole), p => Assert.Equal(1, Math.Pow((p.X - 30) / 9, 2) + Math.Pow((p.Y - 15) / 4, 2), 1e-7));
            foreach (var edge in bounds.Single(b => b.Count == 4))
            {
                var arc = edge as RoundEdge;
                Assert.True(arc is null ? edge is StraightEdge : arc.IsCircular && Math.Abs(Math.Abs(arc.Sweep) - Math.PI) < Mm, $"{edge}");
                Assert.All(PointsOf(edge), p =>
                {
                    // On the stadium: 15 mm from the line between the centers.
                    Assert.Equal(15, new Point2(p.X, p.Y).DistanceTo(new(Math.Clamp(p.X, 0, 60), 15)), Mm);
                    Assert.Equal(face.Origin.Z, p.Z, Mm);
                });
            }

            // Each edge begins where the last one ends.
            Assert.All(bounds, b => Assert.All(b.Zip(b.Skip(1).Append(b[0])), e =>
                Assert.Equal(0, (PointsOf(e.First)[^1] - PointsOf(e.Second)[0]).Length, Mm)));
        }
    }

    private static FlatFaces Read(string script, string unit)
    {
        var output = OcctDraw.Run(
            $"{script}param write.step.unit {unit}\nstepwrite a q w.stp\nset h [open w.stp]\nputs \"<<<[read $h]>>>\"\n");
        var (from, to) = (output.IndexOf("<<<", StringComparison.Ordinal) + 3, output.IndexOf(">>>", StringComparison.Ordinal));
        return FlatFaces.Read(Encoding.ASCII.GetBytes(output[from..to]), "w.stp");
    }

    // Eleven places from the start to the end.
    private static Point3[] PointsOf(FaceEdge edge) => [.. Enumerable.Range(0, 11).Select(i => At(edge, i / 10.0))];

    private static Point3 At(FaceEdge edge, double share) => edge switch
    {
        StraightEdge line => line.From + ((line.To - line.From) * share),
        RoundEdge arc when arc.Start + (share * arc.Sweep) is var t => arc.Center + (arc.X * Math.Cos(t)) + (arc.Y * Math.Sin(t)),
        SplineEdge { Curve: var curve } => curve.PointAt(curve.Knots.Start + (share * (curve.Knots.End - curve.Knots.Start))),
        _ => throw new InvalidOperationException(edge.GetType().Name),
    };
}
