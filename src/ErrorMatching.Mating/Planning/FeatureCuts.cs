using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Which motions of a program are made as the cuts of the features are: with a tool that cuts a feature, in a work offset in which
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
        (_path, _tools, _frames) = (path, [.. motions.Select(path.ToolChangesBefore)], [.. motions.Select(FrameOf)]);

        NcFrame FrameOf(int motion) => Placed(path.Frames[path.Motions[motion].Frame]);
    }

    /// <summary>True for a motion that is made as they are.</summary>
    public bool Hold(int motion) => _tools.Contains(_path.ToolChangesBefore(motion)) && HoldPlaceOf(motion);

    /// <summary>True for a motion in their work offset, with any tool.</summary>
    public bool HoldPlaceOf(int motion) => _frames.Contains(Placed(_path.Frames[_path.Motions[motion].Frame]));

    // Where a frame lies, wherever it is switched on. Motions are in work coordinates: what transforms programmed ones is in them. What
    // only the machine knows of the rotation stays as it is.
    private static NcFrame Placed(NcFrame frame) => frame with
    {
        Block = 0,
        Rotation = frame.Rotation ?? 0,
        ProgramShift = Vector3.Zero,
        IsTransformed = false,
    };
}
