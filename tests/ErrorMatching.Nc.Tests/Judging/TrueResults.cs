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
            var isWritten = WriteOne(folder, seed);
            (written, refused) = isWritten ? (written + 1, refused) : (written, refused + 1);
        }

        return refused;
    }

    /// <summary>Writes results of contours to which upright arcs lead.</summary>
    /// <returns>The number of results; the product refused the others.</returns>
    public static int WriteLed(string folder, int count) => Enumerable.Range(0, count).Count(i => WriteOne(folder, (10 * i) + 9));

    private static bool WriteOne(string folder, int seed)
    {
        if (Displaced(seed) is not var (path, result, certificate))
        {
            return false;
        }

        var name = Path.Combine(folder, seed.ToString("D5", CultureInfo.InvariantCulture));
        File.WriteAllBytes(name + ".base", path.Program.Bytes.ToArray());
        File.WriteAllBytes(name + ".result", result.Bytes.ToArray());
        File.WriteAllBytes(name + ".json", certificate.ToBytes());
        return true;
    }

    // Null where the product refuses.
    private static (NcPath Path, NcProgram Result, Certificate Certificate)? Displaced(int seed)
    {
        var (path, wish) = seed % 10 == 9 ? OfLed(seed) : seed % 4 == 3 ? OfPolygon(seed) : OfContour(seed);
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

    // Its lines are named, or also the upright arcs that lead in and out.
    private static (NcPath Path, DisplacementWish Wish) OfLed(int seed)
    {
        var (contour, isSiemens) = (new LedContour(seed), seed % 60 == 29);
        var spelled = contour.Spell(seed % 20 == 19, seed % 30 == 9 ? "R" : isSiemens ? "CR=" : "");
        var path = Bench.Read(spelled, isSiemens ? NcDialects.Siemens840D : NcDialects.FanucMill);
        var distance = (seed % 7 == 0 ? -0.001 : 0.001) * (1 + (seed % 200));
        var named = Bench.Blocks(path, seed % 40 < 20 ? "N5..N201"
            : "N101..N" + (100 + contour.Count).ToString(CultureInfo.InvariantCulture));
        return (path, Bench.Usable(seed % 50 == 49
            ? DisplacementWish.EndsBy(path, named, new(distance, -distance / 2, seed % 100 == 99 ? distance / 4 : 0))
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
