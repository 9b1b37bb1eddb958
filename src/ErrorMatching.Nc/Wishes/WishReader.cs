using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Reads a wish and checks it against its program. Time and memory grow with its length.</summary>
internal static class WishReader
{
    private static readonly Lazy<JsonSchema> Schema = new(ReadSchema);

    public static WishFile Read(ReadOnlySpan<byte> bytes, string file)
    {
        // Written by this library for programs of a million blocks, so only the size in bytes limits its values.
        var root = JsonInput.Read(bytes, file, JsonLimits.Default with { MaxBytes = WishFile.MaxBytes, MaxValues = WishFile.MaxBytes });
        if (Schema.Value.Check(root) is { Count: > 0 } problems)
        {
            throw new InputException(file, problems);
        }

        var ends = root.Find("endPoints");
        var items = (ends?["motions"] ?? root["elements"]).Items;
        var motions = items.Select(i => new WishedMotion(i["block"].Text, (int)i["line"].Number, (int)i["motion"].Number, i))
            .OrderBy(m => m.Motion)
            .ToArray();
        RefuseTwins(motions, file);
        var marker = root["marker"] is { Kind: JsonItemKind.Text } text ? text.Text : null;
        var wish = ends is not null
            ? EndPoints(motions, ToVector3(ends["by"]))
            : DisplacementWish.OfElements([.. motions.Select(m => ToElement(m.Motion, m.Source!))]);
        return new(root["dialect"].Text, root["beforeSha256"].Text, root["leastIncrementMm"].Number, marker, wish, motions)
        {
            BlockSkip = BlockSkips.Of(root.Find("blockSkip")?.Text),
            ToolRadii = Radii(root),
            Assumed = Assumed(root, file),
        };
    }

    private static AssumedValues Assumed(JsonItem root, string file)
    {
        var values = new Dictionary<string, double>(StringComparer.Ordinal);
        foreach (var item in root.Find("assume")?.Items ?? [])
        {
            var variable = item["variable"];
            if (!AssumedValues.IsName(variable.Text))
            {
                throw new InputException(file,
                    [JsonRefusal.At(variable, "bad-variable", $"\"{variable.Text}\"", "the name of a variable, such as #100 or R5")]);
            }

            values[variable.Text] = item["value"].Number;
        }

        return AssumedValues.Of(values);
    }

    private static ToolRadii Radii(JsonItem root)
    {
        var radii = new Dictionary<int, double>();
        foreach (var tool in root.Find("toolRadii")?.Items ?? [])
        {
            radii[(int)tool["number"].Number] = tool["radiusMm"].Number;
        }

        return ToolRadii.OfTable(radii, root.Find("toolRadiusMm")?.Number);
    }

    /// <summary>Checks a wish against its program.</summary>
    /// <exception cref="InputException">It names something that the program does not have.</exception>
    public static void CheckAgainst(WishFile wish, NcPath before, string file)
    {
        var problems = new List<Refusal>();
        var coarsest = Math.Max(
            Elementary.Pow(10, -before.Dialect.MetricDecimals), 25.4 * Elementary.Pow(10, -before.Dialect.InchDecimals));
        if (!(wish.LeastIncrementMm <= coarsest * 1.000001))
        {
            problems.Add(Problem(
                "increment-too-coarse",
                "$.leastIncrementMm",
                Number(wish.LeastIncrementMm),
                $"at most {Number(coarsest)} mm, the least increment of {before.Dialect.Name}"));
        }

        for (var i = 0; i < wish.Motions.Count; i++)
        {
            var named = wish.Motions[i];
            if (Mistake(named, before) is { } mistake)
            {
                problems.Add(At(named, "no-such-motion", $"motion {Number(named.Motion)} in line {Number(named.Line)}", mistake));
            }
            else if (wish.Wish.Elements.Count > 0 && !CanBe(wish.Wish.Elements[i], before.Motions[named.Motion]))
            {
                problems.Add(At(
                    named, "no-element", $"motion {Number(named.Motion)}", "a cut in a plane that has a direction after its displacement"));
            }
        }

        if (problems.Count > 0)
        {
            throw new InputException(file, problems);
        }
    }

    // What the program has instead; null if it matches.
    private static string? Mistake(WishedMotion named, NcPath before)
    {
        if (named.Motion >= before.Motions.Length)
        {
            return $"one of the {Number(before.Motions.Length)} motions of the program, counted from 0";
        }

        var block = before.Program[before.Motions[named.Motion].Block];
        var number = before.Program.NumberOf(block);
        return block.Line == named.Line && number == named.Block
            ? null
            : $"line {Number(block.Line)}, block \"{number}\", where this motion is";
    }

    private static bool CanBe(ElementWish element, in NcMotion motion)
    {
        if (motion is not { IsCut: true, MovesInPlane: true, IsKnownInPlane: true })
        {
            return false;
        }

        var (start, end) = (motion.PlaneStart + element.Start, motion.PlaneEnd + element.End);
        return motion.IsArc || start.DistanceTo(end) > 1e-9;
    }

    private static void RefuseTwins(WishedMotion[] motions, string file)
    {
        var problems = new List<Refusal>();
        for (var i = 1; i < motions.Length; i++)
        {
            if (motions[i].Motion == motions[i - 1].Motion)
            {
                problems.Add(At(motions[i], "motion-twice", $"motion {Number(motions[i].Motion)} again", "each motion once"));
            }
        }

        if (problems.Count > 0)
        {
            throw new InputException(file, problems);
        }
    }

    // One vector for all end points, or an own vector for each if any motion has one.
    private static DisplacementWish EndPoints(WishedMotion[] motions, Vector3 by) => motions.Any(m => m.Source!.Find("by") is not null)
        ? DisplacementWish.OfPoints(
            [.. motions.Select(m => new PointWish(m.Motion, m.Source!.Find("by") is { } own ? ToVector3(own) : by))])
        : DisplacementWish.OfEndPoints([.. motions.Select(m => m.Motion)], by);

    private static ElementWish ToElement(int motion, JsonItem item)
    {
        var start = ToVector2(item["start"]);
        var (middle, end) = (item.Find("middle"), item.Find("end"));
        return new(
            motion,
            start,
            middle is null ? start : ToVector2(middle),
            end is null ? start : ToVector2(end),
            item.Find("fillet") is { Flag: true });
    }

    private static Vector2 ToVector2(JsonItem list) => new(list.Items[0].Number, list.Items[1].Number);

    private static Vector3 ToVector3(JsonItem list) => new(list.Items[0].Number, list.Items[1].Number, list.Items[2].Number);

    private static Refusal At(WishedMotion named, string code, string found, string expected) =>
        named.Source is { } source ? JsonRefusal.At(source, code, found, expected) : Problem(code, "$", found, expected);

    private static Refusal Problem(string code, string path, string found, string expected) =>
        Refusal.Of(code, found, expected, new() { Line = 1, Column = 1, Path = path });

    private static string Number(IFormattable value) => value.ToString(null, CultureInfo.InvariantCulture);

    private static JsonSchema ReadSchema()
    {
        using var stream = typeof(WishReader).Assembly.GetManifestResourceStream("wish.schema.json")!;
        using var buffer = new MemoryStream();
        stream.CopyTo(buffer);
        return JsonSchema.Parse(buffer.ToArray(), "wish.schema.json");
    }
}
