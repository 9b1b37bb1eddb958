using System.Globalization;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Drafts that can be used, by a seed.</summary>
internal static class RandomDraft
{
    public static MatingDraft Of(int seed)
    {
        var random = new Random(seed);
        var next = 1;
        var hasZ = random.Next(2) == 0;
        var features = Enumerable.Range(0, random.Next(1, 5)).Select(i => Feature(i)).ToArray();
        var others = Points(random.Next(0, 3));
        var (line, triangle) = (
            features.FirstOrDefault(f => f.Kind == LineKind.Instance), features.FirstOrDefault(f => f.Kind == TriangleKind.Instance));
        return new()
        {
            Name = Any("Housing", "殼體", "a \"quoted\" name"),
            WorkOrder = Any("", "WO-1"),
            MeasuredFile = Any("part.csv", "../x/part.csv"),
            Gauge = new()
            {
                Format = Any("points", "feature-table"),
                Uncertainty = Any("0.0054", "0"),
                Reports = "stylus-center",
                StylusDiameter = "2.000",
                Touches = Any("", "14"),
                Calculating = Any("", "0"),
                AcceptsCoarse = random.Next(2) == 0,
            },
            Alignment = random.Next(3) switch
            {
                0 => new(),
                1 => new("datum", features[0].Flanks[0][0].Label, features[0].Flanks[0][1].Label),
                _ => new("best-fit", LockX: random.Next(2) == 0, LockRotation: random.Next(2) == 0)
            },
            OriginPoint = others.Length > 0 ? others[0].Label : "",
            OriginLimit = others.Length > 0 ? "0.01" : "",
            Features = features,
            OtherPoints = others,
            Counterpart = new("counterpart.nc", Any("generic", "delta-nc300"), "6", "counterpart.csv", Any("none", "x", "y"),
                Any("", "-12.5"), "0", Number(), Any("", "0.5"), Any("", "off", "on")),
            Compensation = new(
                Any("part", "counterpart"), Any("", "1.0", "0.5"), Any("whole", "excess"), Any("normal", "vector"), Any("", "1.0")),
            Decision = random.Next(2) == 0 ? new() : new("guard-band", Any("", "2.5")),
            Chain = [new("housing", "17.5", "-0.03", "0.03", "1"), new("cover", "15", "-0.02", "0.02", "-1")],
            Comparisons =
            [
                new("all in x", "deviation-x", string.Join(", ", features[0].Flanks[0].Select(p => p.Label))),
                .. line is null || triangle is null
                    ? []
                    : new[] { new ComparisonDraft("corner", "angle", $"{line.Name}, {triangle.Name}/1") },
            ],
            RecognitionJson = Any(
                "", """{"part":[{"in":"file-name","pattern":"^part"}],"counterpart":[{"in":"file-name","pattern":"^counter"}]}"""),
            SchemaUri = Any("", "mating.schema.json"),
        };

        FeatureDraft Feature(int i)
        {
            var kind = FeatureKinds.All[random.Next(FeatureKinds.All.Count)];
            return new()
            {
                Kind = kind,
                Name = string.Create(CultureInfo.InvariantCulture, $"{Any("L", "線 ")}{i}"),
                Flanks = [.. kind.LeastPoints.Select(least => Points(random.Next(Math.Max(least, 3), least + 5)))],
                Blocks = Any("N120", "N130..N160, N200", "/^N8[0-9]{3}\\b.*\\bG0?3\\b/", "/a, b; c/, n7"),
                Tolerance = Any("stated", "chain:rss", "chain:worst-case") is var t ? t : "",
                Lower = t == "stated" ? "-0.050" : "",
                Upper = t == "stated" ? "0.05" : "",
                Plane = Any("XY", "ZX", "YZ"),
                Keys = kind.Keys.ToDictionary(k => k.Name, k => k.Words.Count > 0 ? Any([.. k.Words]) : Any("", "auto", "2")),
            };
        }

        PointDraft[] Points(int count) => [
            .. Enumerable.Range(0, count).Select(_ => new PointDraft(
                string.Create(CultureInfo.InvariantCulture, $"{Any("", "P", "點")}{next++}"), Number(), Number(), hasZ ? Number() : ""))];
        string Number() => (random.Next(-100_000, 100_000) / 1000m).ToString(Any("0.000", "0.###"), CultureInfo.InvariantCulture);
        string Any(params string[] words) => words[random.Next(words.Length)];
    }
}
