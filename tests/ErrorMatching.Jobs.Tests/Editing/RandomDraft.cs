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
        var draft = new MatingDraft { Features = features, OtherPoints = others };
        foreach (var (path, text) in Texts().Concat(Alignment()).Concat(Lists()))
        {
            draft = draft.With(path, text);
        }

        return draft;

        (string, string)[] Texts() => [
            ("$.$schema", Any("", "mating.schema.json")),
            ("$.name", Any("Housing", "殼體", "a \"quoted\" name", "42")),
            ("$.workOrder", Any("", "WO-1", "7")),
            ("$.part.measured", Any("part.csv", "../x/part.csv")),
            ("$.gauge.format", Any("points", "feature-table")),
            ("$.gauge.uncertaintyMm", Any("0.0054", "0")),
            ("$.gauge.reports", "stylus-center"),
            ("$.gauge.stylusDiameterMm", "2.000"),
            ("$.gauge.measuring.touches", Any("", "14")),
            ("$.gauge.measuring.calculatingS", Any("", "0")),
            ("$.gauge.acceptCoarse", Any("", "true")),
            ("$.originCheck.point", others.Length > 0 ? others[0].Label : ""),
            ("$.originCheck.limitMm", others.Length > 0 ? "0.01" : ""),
            ("$.counterpart.program", "counterpart.nc"),
            ("$.counterpart.dialect", Any("generic", "delta-nc300")),
            ("$.counterpart.toolDiameterMm", "6"),
            ("$.counterpart.measured", "counterpart.csv"),
            ("$.counterpart.frame.mirror", Any("", "none", "x", "y")),
            ("$.counterpart.frame.rotateDeg", Any("", "-12.5")),
            ("$.counterpart.frame.translateMm[0]", "0"),
            ("$.counterpart.frame.translateMm[1]", Number()),
            ("$.counterpart.mapMm", Any("", "0.5")),
            ("$.counterpart.blockSkip", Any("", "off", "on")),
            ("$.compensation.from", Any("", "part", "counterpart")),
            ("$.compensation.gain", Any("", "1.0", "0.5")),
            ("$.compensation.amount", Any("", "whole", "excess")),
            ("$.compensation.along", Any("", "normal", "vector")),
            ("$.compensation.limitMm", Any("", "1.0"))];

        IEnumerable<(string, string)> Alignment()
        {
            var kind = Any("", "none", "datum", "best-fit");
            yield return ("$.alignment.kind", kind);
            yield return ("$.alignment.locked", kind == "best-fit" ? Any("", "x", "x, rotation") : "");
            yield return ("$.alignment.origin", kind == "datum" ? features[0].Flanks[0][0].Label : "");
            yield return ("$.alignment.direction", kind == "datum" ? features[0].Flanks[0][1].Label : "");
            var rule = Any("", "simple", "guard-band");
            yield return ("$.decision.rule", rule);
            yield return ("$.decision.riskPercent", rule == "guard-band" ? Any("", "2.5") : "");
        }

        IEnumerable<(string, string)> Lists()
        {
            foreach (var (i, link) in new[] { ("housing", "17.5", "-0.03", "0.03", "1"), ("cover", "15", "-0.02", "0.02", "-1") }.Index())
            {
                yield return ($"$.toleranceChain[{i}].name", link.Item1);
                yield return ($"$.toleranceChain[{i}].nominalMm", link.Item2);
                yield return ($"$.toleranceChain[{i}].toleranceMm[0]", link.Item3);
                yield return ($"$.toleranceChain[{i}].toleranceMm[1]", link.Item4);
                yield return ($"$.toleranceChain[{i}].sign", link.Item5);
            }

            yield return ("$.verify[0].name", "all in x");
            yield return ("$.verify[0].quantity", "deviation-x");
            yield return ("$.verify[0].points", string.Join(", ", features[0].Flanks[0].Select(p => p.Label)));
            if (line is not null && triangle is not null)
            {
                yield return ("$.verify[1].name", "corner");
                yield return ("$.verify[1].quantity", "angle");
                yield return ("$.verify[1].between", $"{line.Name}, {triangle.Name}/1");
            }
        }

        FeatureDraft Feature(int i)
        {
            var kind = FeatureKinds.All[random.Next(FeatureKinds.All.Count)];
            var feature = new FeatureDraft
            {
                Kind = kind,
                Name = string.Create(CultureInfo.InvariantCulture, $"{Any("L", "線 ")}{i}"),
                Flanks = [.. kind.LeastPoints.Select(least => Points(random.Next(Math.Max(least, 3), least + 5)))],
                Blocks = Any("N120", "N130..N160, N200", "/^N8[0-9]{3}\\b.*\\bG0?3\\b/", "/a, b; c/, n7"),
                Tolerance = Any("stated", "chain:rss", "chain:worst-case") is var t ? t : "",
                Lower = t == "stated" ? "-0.050" : "",
                Upper = t == "stated" ? "0.05" : "",
                Plane = Any("XY", "ZX", "YZ"),
            };
            return kind.Keys.Aggregate(feature, (f, k) => f.With(k.Name, k.Words.Count > 0 ? Any([.. k.Words]) : Any("", "auto", "2")));
        }

        PointDraft[] Points(int count) => [
            .. Enumerable.Range(0, count).Select(_ => new PointDraft(
                string.Create(CultureInfo.InvariantCulture, $"{Any("", "P", "點")}{next++}"), Number(), Number(), hasZ ? Number() : ""))];
        string Number() => (random.Next(-100_000, 100_000) / 1000m).ToString(Any("0.000", "0.###"), CultureInfo.InvariantCulture);
        string Any(params string[] words) => words[random.Next(words.Length)];
    }
}
