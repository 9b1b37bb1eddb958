namespace ErrorMatching.Freeform;

/// <summary>Why readable inputs give no result. A refusal is a normal outcome, not an exception.</summary>
/// <param name="Code">A stable identifier for scripts, such as <c>beyond-limit</c>.</param>
/// <param name="Message">The problem, its location (point, place on the surface, block) and the remedy, in a setter's words.</param>
public sealed record FreeformRefusal(string Code, string Message);
