using System.Globalization;

namespace ErrorMatching.Nc.Tests;

/// <summary>Random contours, displaced and proved by the product, in all spellings and kinds of wishes that the judge reads.</summary>
internal static class TrueResults
{
    private static readonly string[] Planes = ["G17", "G18", "G19"];

    /// <summary>Writes results with their originals and certificates to a folder.</summary>
    /// <returns>The number of contours that the product refused.</returns>
    public static int Write(string folder, int count)
    {
        var refused = 0;
        for (int seed = 1, written = 0; written < count; seed++)
        {
            if (Displaced(seed) is var (path, result, certificate))
            {
                var name = Path.Combine(folder, seed.ToString("D5", CultureInfo.InvariantCulture));
                File.WriteAllBytes(name + ".base", path.Program.Bytes.ToArray());
                File.WriteAllBytes(name + ".result", result.Bytes.ToArray());
                File.WriteAllBytes(name + ".json", certificate.ToBytes());
                written++;
            }
            else
            {
                refused++;
            }
        }

        return refused;
    }

    // Null where the product refuses.
    private static (NcPath Path, NcProgram Result, Certificate Certificate)? Displaced(int seed)
    {
        var (path, wish) = seed % 4 == 3 ? OfPolygon(seed) : OfContour(seed);
        var rewrite = Rewriter.Apply(path, wish);
        if (!rewrite.IsUsable)
        {
            return null;
        }

        var (result, marker) = (rewrite.Result.Program, (string?)null);
        if (seed % 3 == 0)
        {
            var inserted = new Marker(new('a', 64), WishFile.Of(path, wish, rewrite.Result.LeastIncrementMm).BeforeSha256);
            (result, marker) = (NcProgram.Read(inserted.InsertInto(result), result.Syntax), inserted.TextIn(result.Syntax));
        }

        var proof = Prover.Check(path, result, wish, rewrite.Result.LeastIncrementMm, marker);
        Assert.Empty(proof.Failures);
        return (path, result, Certificate.Of(path, result, wish, rewrite.Result.LeastIncrementMm, proof));
    }

    private static (NcPath Path, DisplacementWish Wish) OfContour(int seed)
    {
        var contour = new RandomContour(seed, onlyLines: seed % 5 == 4, anyCorner: seed % 7 == 3);
        var (path, named) = Read(contour, seed);
        var distance = Math.Round(contour.Uniform(-0.3, 0.3), 4);
        return (path, Bench.Usable(seed % 4 == 0
            ? DisplacementWish.EndsBy(path, named, new(distance, -distance / 2, seed % 8 == 0 ? distance / 4 : 0))
            : DisplacementWish.Normal(path, named, distance)));
    }

    // Its lines are named, and its arcs as fillets or not at all; a quarter of the lines tilt.
    private static (NcPath Path, DisplacementWish Wish) OfPolygon(int seed)
    {
        var (polygon, random) = (new RoundedPolygon(seed), new RandomContour(seed));
        var path = Bench.Read(polygon.Text, NcDialects.DeltaNc300);
        var (left, namesArcs, tilts) = (Math.Round(random.Uniform(-0.2, 0.2), 4), seed % 8 == 3, seed % 16 == 7);
        var elements = new List<ElementWish>();
        for (var n = 0; n < polygon.IsArc.Count; n++)
        {
            var motion = path.MotionOf(Bench.Blocks(path, "N" + (n + 1).ToString(CultureInfo.InvariantCulture))[0]);
            var (isArc, end) = (polygon.IsArc[n], tilts && !polygon.IsArc[n] ? left * random.Uniform(0.5, 1.5) : left);
            if (!isArc || namesArcs)
            {
                elements.Add(ElementWish.AlongNormals(path, motion, left, left, end, isFillet: isArc));
            }
        }

        return (path, DisplacementWish.OfElements(elements));
    }

    private static (NcPath Path, int[] Named) Read(RandomContour contour, int seed)
    {
        var path = seed % 6 == 5
            ? Bench.Read(contour.SpellSiemens(seed % 12 == 5), NcDialects.Siemens840D)
            : Bench.Read(contour.Spell(seed % 2 == 0, Planes[seed / 2 % 3], byRadius: seed % 5 == 0), NcDialects.FanucMill);
        var (first, chosen) = (1 + (contour.Count / 4), Enumerable.Range(1, contour.Count));
        chosen = seed % 9 == 8
            ? chosen.Where(_ => contour.Uniform(0, 1) < 0.5).DefaultIfEmpty(1)
            : chosen.Where(n => n >= first && n < Math.Max(first + 1, contour.Count));
        return (path, [.. chosen.SelectMany(n => Bench.Blocks(path, "N" + n.ToString(CultureInfo.InvariantCulture)))]);
    }
}
