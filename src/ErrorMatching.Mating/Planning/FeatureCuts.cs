using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Which motions of a program are made as the cuts of the features are: between the same tool changes, in a work offset in which
/// one is cut. Of the others, neither the tool's diameter nor their place beside the features is known.</summary>
internal sealed class FeatureCuts
{
    private readonly NcPath _path;
    private readonly HashSet<int> _tools;
    private readonly HashSet<NcFrame> _frames;

    /// <summary>Looks at what cuts the features.</summary>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    public FeatureCuts(NcPath path, IReadOnlyList<FeatureMap> maps)
    {
        int[] motions = [.. maps.SelectMany(m => m.Passes).SelectMany(p => FeaturePass.Moving(path, p.First, p.Last))];
        (_path, _frames) = (path, [.. motions.Select(FrameOf)]);

        // A path of centers shows by its distance that its tool is the job's. Under cutter compensation any tool makes the same path:
        // there, the one that cuts a feature last.
        var compensated = motions.ToLookup(
            m => path.Motions[m].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight), path.ToolChangesBefore);
        _tools = [.. compensated[false], .. compensated[true].Order().TakeLast(1)];

        NcFrame FrameOf(int motion) => Placed(path.Frames[path.Motions[motion].Frame]);
    }

    /// <summary>True for a motion that is made as they are.</summary>
    public bool Hold(int motion) => _tools.Contains(_path.ToolChangesBefore(motion)) && HoldPlaceOf(motion);

    /// <summary>True for a motion in their work offset, with any tool.</summary>
    public bool HoldPlaceOf(int motion) => _frames.Contains(Placed(_path.Frames[_path.Motions[motion].Frame]));

    // Where a frame lies, wherever it is switched on. Motions are in work coordinates: what transforms programmed ones is in them. What
    // only the machine knows of the rotation stays as it is; an unknown shift may be another one each time.
    private static NcFrame Placed(NcFrame frame) => frame with
    {
        Block = frame.UnknownShift == AxisSet.None ? 0 : frame.Block,
        Rotation = frame.Rotation ?? 0,
        ProgramShift = Vector3.Zero,
        IsTransformed = false,
    };
}
