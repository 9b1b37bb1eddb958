using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Selects a surface of a file: by name, by number from 1, or the only one.</summary>
internal static class SurfaceChoice
{
    private const int Listed = 12;
    private const int Places = 16;

    /// <summary>Returns the index of the selected surface.</summary>
    /// <param name="file">File name for messages.</param>
    /// <param name="names">The name of each surface, empty if it has none; at least one.</param>
    /// <param name="entity">Name or number; null for the only one.</param>
    /// <param name="read">Reads a surface, to report its extent.</param>
    /// <exception cref="InputException">No surface matches, or several do.</exception>
    public static int Choose(string file, IReadOnlyList<string> names, string? entity, Func<int, ReadSurface> read)
    {
        if (entity is null)
        {
            return names.Count == 1
                ? 0
                : throw InputException.At(
                    "several-surfaces",
                    file,
                    $"it has {names.Count} surfaces: {List(names, read)}. Say which one by name or number (\"surfaceEntity\" in the job)");
        }

        var named = Enumerable.Range(0, names.Count).Where(i => names[i] == entity).ToList();
        return named.Count == 1 ? named[0]
            : named.Count > 1
                ? throw InputException.At(
                    "several-surfaces",
                    file,
                    $"{named.Count} surfaces are called {ExchangeLimits.Quote(entity)}: say which one by number: {List(names, read)}")
            : int.TryParse(entity, NumberStyles.None, CultureInfo.InvariantCulture, out var number) && number >= 1 && number <= names.Count
                ? number - 1
            : throw InputException.At(
                "no-such-surface", file, $"no surface is called or numbered {ExchangeLimits.Quote(entity)}; it has {List(names, read)}");
    }

    /// <summary>The name of a surface, or its number if it has no name.</summary>
    public static string NameOf(IReadOnlyList<string> names, int index) =>
        names[index].Length > 0 ? names[index] : (index + 1).ToString(CultureInfo.InvariantCulture);

    private static string List(IReadOnlyList<string> names, Func<int, ReadSurface> read)
    {
        var shown = Enumerable.Range(0, Math.Min(Listed, names.Count)).Select(i => string.Create(
            CultureInfo.InvariantCulture,
            $"{i + 1}{(names[i].Length > 0 ? " " + ExchangeLimits.Quote(names[i]) : "")} ({Extent(() => read(i))})"));
        return string.Join(", ", shown) + (names.Count > Listed ? ", ..." : "");
    }

    // The extent identifies surfaces without names.
    private static string Extent(Func<ReadSurface> read)
    {
        try
        {
            var surface = read();
            var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
            var places = from i in Enumerable.Range(0, Places + 1)
                         from j in Enumerable.Range(0, Places + 1)
                         select new Point2(u.Start + ((u.End - u.Start) * i / Places), v.Start + ((v.End - v.Start) * j / Places));
            var points = surface.Region.Loops.SelectMany(l => l)
                .Concat(places.Where(q => surface.Region.Contains(q.X, q.Y)))
                .Select(q => surface.Spline.PointAt(q.X, q.Y))
                .ToArray();
            return string.Create(
                CultureInfo.InvariantCulture,
                $"x {points.Min(p => p.X):0.#} to {points.Max(p => p.X):0.#}, y {points.Min(p => p.Y):0.#} to "
                    + $"{points.Max(p => p.Y):0.#}, z {points.Min(p => p.Z):0.#} to {points.Max(p => p.Z):0.#}");
        }
        catch (InputException e)
        {
            return e.Code;
        }
    }
}
