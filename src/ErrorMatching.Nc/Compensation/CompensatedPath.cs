using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The path of the tool's center: the programmed path with cutter compensation applied as the dialect's control does it.</summary>
public sealed class CompensatedPath
{
    private CompensatedPath(NcPath path, IReadOnlyList<CompensatedMotion> motions, Refusal? refusal) =>
        (Path, Motions, Refusal) = (path, motions, refusal);

    /// <summary>The programmed path.</summary>
    public NcPath Path { get; }

    /// <summary>The motions of the tool's center, in execution order, up to the block that is refused.</summary>
    public IReadOnlyList<CompensatedMotion> Motions { get; }

    /// <summary>The reason why the control would stop, or why its path is not followed further; null if it is followed to its
    /// end.</summary>
    public Refusal? Refusal { get; }

    /// <summary>True if a program uses cutter compensation somewhere.</summary>
    public static bool Concerns(NcPath path) => path.CompensationSwitches.Any(s => s.Meaning
        is NcMeaning.CompensationLeft or NcMeaning.CompensationRight
        or NcMeaning.CompensationLeftByDiameter or NcMeaning.CompensationRightByDiameter);

    /// <summary>Follows the tool's center.</summary>
    /// <param name="path">The programmed path; its dialect has the radii that the control uses (<see cref="NcDialect.ToolRadii"/>).</param>
    /// <param name="cancellation">Stops a long run.</param>
    /// <exception cref="OperationCanceledException">The run was canceled.</exception>
    public static CompensatedPath Of(NcPath path, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(path);
        return Of(path, path.Dialect.ToolRadii, cancellation);
    }

    /// <summary>Follows the tool's center for other radii than the dialect's.</summary>
    /// <param name="path">The programmed path.</param>
    /// <param name="radii">The radii that the control uses.</param>
    /// <param name="cancellation">Stops a long run.</param>
    /// <exception cref="OperationCanceledException">The run was canceled.</exception>
    public static CompensatedPath Of(NcPath path, ToolRadii radii, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(path);
        var motions = new List<CompensatedMotion>(path.Motions.Length);
        return new(path, motions, new CompensationRun(path, radii, motions).Follow(cancellation) ?? path.Refusal);
    }

    /// <summary>The reason why the control would stop, or why the path of the tool's center is not followed; null if it is followed to its
    /// end.</summary>
    /// <param name="path">The programmed path.</param>
    /// <param name="lead">Begins the message after the name of the block.</param>
    public static Refusal? Check(NcPath path, string lead = "") =>
        Concerns(path) ? new CompensationRun(path, path.Dialect.ToolRadii, null, lead).Follow(CancellationToken.None) : null;

    /// <summary>True if a refusal says that the control would stop, and not only that its path is not followed.</summary>
    public static bool Stops(Refusal refusal) =>
        refusal.Code is NcRefusalCodes.CompensationGouge or NcRefusalCodes.CompensationEntry or NcRefusalCodes.CompensationStop;
}
