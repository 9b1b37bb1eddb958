namespace ErrorMatching.Freeform;

/// <summary>Why no result comes of inputs that can be read: a normal outcome, not an exception.</summary>
/// <param name="Code">A stable word for scripts, such as <c>beyond-limit</c>.</param>
/// <param name="Message">What is wrong, where (point, place on the surface, block), and what to do, in a setter's words.</param>
public sealed record FreeformRefusal(string Code, string Message);
