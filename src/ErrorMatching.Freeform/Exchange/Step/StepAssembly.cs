using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Detects STEP files that move their parts. A surface is then not at its own coordinates.</summary>
internal static class StepAssembly
{
    /// <summary>Throws if the file places a part away from where it was modeled.</summary>
    /// <exception cref="InputException">A part is moved.</exception>
    public static void ThrowIfMoved(StepFile file)
    {
        foreach (var instance in file.Where(
            k => k is "MAPPED_ITEM" or "ITEM_DEFINED_TRANSFORMATION" or "CARTESIAN_TRANSFORMATION_OPERATOR_3D"))
        {
            var record = instance.Records[0];
            if (record.Keyword switch
            {
                "MAPPED_ITEM" => !IsAtItsPlace(record),
                "ITEM_DEFINED_TRANSFORMATION" => !Same(StepPlacement.Of(record.Instance(2)), StepPlacement.Of(record.Instance(3))),
                _ => true,
            })
            {
                throw record.Fail(
                    "assembly",
                    "a part that an assembly moves, which is not followed: export the part by itself, in the coordinates in which it is "
                        + "cut");
            }
        }
    }

    // Annotations are shown by cameras, and in draughting models that map the part where it is.
    private static bool IsAtItsPlace(StepRecord item)
    {
        var (map, target) = (item.Instance(1), item.Instance(2));
        var origin = map.Find("REPRESENTATION_MAP")?.Instance(0);
        return origin is not null && (origin.Records.Any(r => r.Keyword.StartsWith("CAMERA_MODEL", StringComparison.Ordinal))
            || origin.Id == target.Id
            || (origin.Keyword == "AXIS2_PLACEMENT_3D" && target.Keyword == "AXIS2_PLACEMENT_3D"
                && Same(StepPlacement.Of(origin), StepPlacement.Of(target))));
    }

    private static bool Same(StepPlacement a, StepPlacement b) =>
        (a.Origin - b.Origin).Length <= 1e-9 && (a.X - b.X).Length <= 1e-12 && (a.Z - b.Z).Length <= 1e-12;
}
