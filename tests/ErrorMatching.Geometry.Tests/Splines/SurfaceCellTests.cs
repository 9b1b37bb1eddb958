using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

/// <summary>What the proof of a closest point rests on, against dense samples.</summary>
public sealed class SurfaceCellTests
{
    private const int Samples = 8;

    private static readonly Gen<SplineSurface> Piece = DrawSpline.Surface.Zip(Gen.Choose(-999, 999).Two()).Select(c =>
    {
        var piece = c.Item1.Pieces()[0];
        var (u, v) = (DrawSpline.Inside(piece.KnotsU, c.Item2.Item1 / 1000.0), DrawSpline.Inside(piece.KnotsV, c.Item2.Item2 / 1000.0));

        // A corner, however small: bounds get tighter with the cell.
        return piece.Between(piece.KnotsU.Start, u, piece.KnotsV.Start, v);
    });

    [Fact]
    public void No_derivative_is_longer_than_its_bound() => Draw.Law(
        Piece,
        surface =>
        {
            var cell = new SurfaceCell(surface);
            var (halfU, halfV) = (0.5 * (surface.KnotsU.End - surface.KnotsU.Start), 0.5 * (surface.KnotsV.End - surface.KnotsV.Start));
            var d = new Vector3[16];
            return Grid(surface).All(p =>
            {
                surface.Derivatives(p.U, p.V, 3, d);
                for (var k = 0; k <= 3; k++)
                {
                    for (var l = k == 0 ? 1 : 0; k + l <= 3; l++)
                    {
                        if (d[(4 * k) + l].Length * Math.Pow(halfU, k) * Math.Pow(halfV, l) > (cell.Bounds[k, l] * (1 + 1e-9)) + 1e-9)
                        {
                            return false;
                        }
                    }
                }

                return true;
            });
        },
        300);

    [Fact]
    public void No_place_is_nearer_than_the_bound() => Draw.Law(
        Piece.Zip(Draw.Coordinate.Three()),
        c =>
        {
            var p = new Point3(c.Item2.Item1, c.Item2.Item2, c.Item2.Item3);
            var bound = new SurfaceCell(c.Item1).DistanceBound(p);
            return Grid(c.Item1).All(g => (c.Item1.PointAt(g.U, g.V) - p).Length > bound - 1e-9);
        });

    [Fact]
    public void Distance_that_is_proven_convex_is() => Draw.Law(
        Piece.Zip(Gen.Choose(-1000, 1000)),
        c =>
        {
            var cell = new SurfaceCell(c.Item1);
            var p = cell.Center.Position + (cell.Center.Normal * (c.Item2 / 20.0));
            return !cell.IsConvexFrom(p) || Grid(c.Item1).All(g =>
            {
                var at = c.Item1.At(g.U, g.V);
                var d = at.Position - p;
                var (uu, uv, vv) = (at.Du.Dot(at.Du) + d.Dot(at.Duu), at.Du.Dot(at.Dv) + d.Dot(at.Duv), at.Dv.Dot(at.Dv) + d.Dot(at.Dvv));
                return uu > 0 && uu * vv > uv * uv;
            });
        });

    [Fact]
    public void Small_cells_of_a_gentle_surface_are_proven_convex()
    {
        // Radius of curvature 20 mm: convex up to 20 mm inside, and everywhere outside.
        var cell = new SurfaceCell(Shapes.Cylinder(20, 50).Between(0.47, 0.5, 0, 0.5));
        Assert.True(cell.IsConvexFrom(cell.Center.Position + (cell.Center.Normal * -15)));
        Assert.True(cell.IsConvexFrom(cell.Center.Position + (cell.Center.Normal * 15)));
        Assert.False(cell.IsConvexFrom(cell.Center.Position + (cell.Center.Normal * -21)));
    }

    private static IEnumerable<(double U, double V)> Grid(SplineSurface surface) =>
        from i in Enumerable.Range(0, Samples + 1)
        from j in Enumerable.Range(0, Samples + 1)
        select (DrawSpline.Inside(surface.KnotsU, (2.0 * i / Samples) - 1), DrawSpline.Inside(surface.KnotsV, (2.0 * j / Samples) - 1));
}
