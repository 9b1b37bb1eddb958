using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>Reads the flat faces of a STEP file as drawings: each outline is a layer.</summary>
internal static class StepDrawing
{
    /// <summary>Maximum number of faces that are drawn. A plate with more holes than that has them in few faces.</summary>
    public const int MaxFaces = 10_000;

    // A model with many faces at one place says no more.
    private const int MaxHeights = 3;

    /// <summary>Reads a file.</summary>
    /// <param name="bytes">Its content.</param>
    /// <param name="file">Its name, for messages.</param>
    /// <param name="unitMm">Millimeters per unit of the file; null to take what it states.</param>
    /// <exception cref="InputException">The file is no STEP file, is broken or too large, or has no flat face perpendicular to an
    /// axis.</exception>
    public static Drawing Read(byte[] bytes, string file, double? unitMm)
    {
        var model = FlatFaces.Read(bytes, file, unitMm);
        if (model.Faces.Count == 0)
        {
            throw InputException.At(
                "no-flat-face",
                file,
                $"no flat face (ADVANCED_FACE or FACE_SURFACE on a PLANE); one is expected, whose edges are the outline. {Others(model)}"
                    .TrimEnd());
        }

        List<string> notes = [];
        var (outlines, curves) = Draw(file, model, Seen(file, model, notes), notes);
        if (curves.Count == 0)
        {
            throw InputException.At("no-curve", file, $"no edge of its flat faces has a length. {string.Join(' ', notes)}".TrimEnd());
        }

        if (Others(model) is { Length: > 0 } others)
        {
            notes.Add(others);
        }

        return new(file, new(model.UnitMm, true), curves, notes)
        {
            Annotations = model.Annotations,
            Standard = model.Standard,
            Places = outlines.ToDictionary(o => o.Outline.Layer, o => Place(o.Outline, o.Name), StringComparer.Ordinal),
        };
    }

    // From above if there is anything to see, else from the side.
    private static List<(FlatFace Face, ModelView View)> Seen(string file, FlatFaces model, List<string> notes)
    {
        var seen = Along(model, [ModelView.AlongZ]);
        var isFromSide = seen.Count == 0;
        seen = isFromSide ? Along(model, ModelView.FromSide) : seen;
        var first = model.Faces[0];
        if (seen.Count == 0)
        {
            throw InputException.At(
                "tilted-faces",
                file,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"no flat face is perpendicular to Z, X or Y ({ReportNumber.Count(model.Faces.Count, "flat face")}; the normal of "
                        + $"{first} is {first.Normal.X:0.#####}, {first.Normal.Y:0.#####}, {first.Normal.Z:0.#####}). "
                        + $"Turn the model as the part is cut, Z along the tool"),
                first.Line);
        }

        if (seen.Count > MaxFaces)
        {
            throw InputException.At(
                "too-large", file, $"{seen.Count} flat faces; at most {MaxFaces} are drawn. Export the part that mates alone");
        }

        if (isFromSide)
        {
            notes.Add(
                $"No flat face is perpendicular to Z. Read instead: {string.Join("; ", seen.Select(s => s.View).Distinct().Select(
                    v => $"those perpendicular to {v.Axis}, with {v.Right} and {v.Up} of the model as X and Y of the drawing"))}.");
        }

        if (model.Faces.Count - seen.Count is > 0 and var passed)
        {
            var drawn = seen.Select(s => s.Face).ToHashSet();
            notes.Add(
                $"Passed over, because they are not perpendicular to {(isFromSide ? "X or Y" : "Z")}: "
                    + $"{ReportNumber.Count(passed, "flat face")} (first: {model.Faces.First(f => !drawn.Contains(f))}).");
        }

        return seen;
    }

    private static List<(FlatFace Face, ModelView View)> Along(FlatFaces model, IReadOnlyList<ModelView> views) =>
        [.. model.Faces.SelectMany(f => views.Where(v => v.Sees(f.Normal)).Select(v => (f, v)))];

    private static (List<(FaceOutline Outline, string Name)> Outlines, List<DrawnCurve> Curves) Draw(
        string file, FlatFaces model, List<(FlatFace Face, ModelView View)> seen, List<string> notes)
    {
        var (pen, outlines) = (new StepPen(file), new List<(FaceOutline Outline, string Name)>());
        var (again, example) = (0, "");
        foreach (var (face, view) in seen)
        {
            var (layer, before) = (string.Create(CultureInfo.InvariantCulture, $"#{face.Number}"), pen.Curves.Count);
            pen.Draw(face, layer, view);
            if (pen.Curves.Count == before)
            {
                continue;
            }

            var outline = new FaceOutline(view, pen.Curves[before..], layer);
            if (outlines.Find(o => o.Outline.IsSameAs(outline)) is { Outline: { } known })
            {
                pen.Curves.RemoveRange(before, pen.Curves.Count - before);
                example = again++ == 0 ? $"{layer} as {known.Layer}" : example;
                known.Heights.Add(view.HeightOf(face.Origin));
                continue;
            }

            for (var c = before; c < pen.Curves.Count && model.Annotations.Count > 0; c++)
            {
                pen.Curves[c] = WithWalls(pen.Curves[c], model, face, view);
            }

            outline.Heights.Add(view.HeightOf(face.Origin));
            outlines.Add((outline, face.Name));
        }

        if (again > 0)
        {
            notes.Add(
                "Counted once, because they have the outline of another face: "
                    + $"{ReportNumber.Count(again, "flat face")} (first: {example}).");
        }

        if (pen.Inside.Count > 0)
        {
            notes.Add(
                "Passed over, because the face is on both sides of them: "
                    + $"{ReportNumber.Count(pen.Inside.Count, "curve")} (first: {pen.Inside.First}).");
        }

        if (pen.NoLengths.Count > 0)
        {
            notes.Add(
                "Passed over as shorter than 0.000001 mm: "
                    + $"{ReportNumber.Count(pen.NoLengths.Count, "curve")} (first: {pen.NoLengths.First}).");
        }

        return (outlines, pen.Curves);
    }

    private static DrawnCurve WithWalls(DrawnCurve curve, FlatFaces model, FlatFace face, ModelView view)
    {
        var middle = view.At(curve.AtLength(curve.LengthMm / 2), view.HeightOf(face.Origin));
        return curve with
        {
            Walls = [
                .. curve.Edges.SelectMany(model.FacesAt).Where(w => w.Number != face.Number).DistinctBy(w => w.Number).Select(
                    w => new DrawnWall(w.Number, view.IsUpright(w), w.OutwardAt(middle) is { } outward ? view.Of(outward) : null))],
        };
    }

    private static string Others(FlatFaces model) => model.Others.Count == 0 ? "" : $"Passed over, because they are not flat: "
        + $"{ReportNumber.Count(model.Others.Values.Sum(), "face")} ({string.Join(", ", model.Others.Select(o => $"{o.Value} {o.Key}"))}).";

    private static string Place(FaceOutline outline, string name)
    {
        var heights = outline.Heights.Select(h => Math.Round(h, 3) + 0.0).Distinct()
            .Select(h => h.ToString("0.###", CultureInfo.InvariantCulture)).ToList();
        var shown = string.Join(", ", heights.Take(MaxHeights)) + (heights.Count > MaxHeights ? ", ..." : "");
        return $" at {outline.View.Axis} {shown} mm" + (name.Length > 0 ? ", " + DrawingLimits.Quote(name) : "");
    }
}
