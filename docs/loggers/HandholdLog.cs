// SPDX-License-Identifier: Apache-2.0
// Logs hands and objects of a Unity application for `handhold judge-log` (docs/judge-log.md). Copy it into Assets.
// The class at the top needs no Unity; the component at the bottom connects it to Unity and to its package XR Hands.
using System;
using System.Globalization;
using System.IO;

/// Unity's coordinates: metres, y up, left-handed.
public sealed class HandholdLog : IDisposable
{
    readonly TextWriter writer;
    string objects = "", hands = "", joints = "";
    double time;

    /// objects: what judge-log must know of each, as JSON, such as {"cube": {"shape": "cube.obj", "mass": 0.1}}.
    /// drawnHands: the joints are those drawn, not those tracked.
    public HandholdLog(TextWriter writer, string objects, bool drawnHands = false)
    {
        this.writer = writer;
        writer.Write("{\"format\": \"openxr\", \"handedness\": \"left\", \"drawn_hands\": "
            + (drawnHands ? "true" : "false") + ", \"objects\": " + objects + "}\n");
    }

    public void BeginFrame(double seconds)
    {
        time = seconds;
        objects = hands = "";
    }

    /// name: of XRHandJointID, in any order; radius 0: unknown.
    public void Joint(string name, float x, float y, float z, float radius)
    {
        Add(ref joints, "{\"name\": \"" + name + "\", \"position\": " + Numbers(x, y, z)
            + ", \"radius\": " + Number(radius) + "}");
    }

    /// The joints since the last hand are those of this one.
    public void EndHand(bool right)
    {
        Add(ref hands, (right ? "\"right\"" : "\"left\"") + ": {\"joints\": [" + joints + "]}");
        joints = "";
    }

    public void Object(string name, float x, float y, float z, float qx, float qy, float qz, float qw)
    {
        Add(ref objects, "\"" + name + "\": {\"position\": " + Numbers(x, y, z)
            + ", \"orientation\": " + Numbers(qx, qy, qz, qw) + "}");
    }

    public void EndFrame()
    {
        writer.Write("{\"t\": " + time.ToString("R", CultureInfo.InvariantCulture) + ", \"hands\": {" + hands
            + "}, \"objects\": {" + objects + "}}\n");
    }

    public void Dispose() { writer.Dispose(); }

    static void Add(ref string list, string item) { list += (list == "" ? "" : ", ") + item; }
    static string Number(float x) { return x.ToString("R", CultureInfo.InvariantCulture); }
    static string Numbers(params float[] x) { return "[" + string.Join(", ", Array.ConvertAll(x, Number)) + "]"; }
}

#if UNITY_5_3_OR_NEWER
/// Put it on any object of the scene; name the objects to log, and their shapes, in the inspector.
public sealed class HandholdLogger : UnityEngine.MonoBehaviour
{
    [UnityEngine.TextArea] public string objects = "{\"cube\": {\"shape\": \"cube.obj\", \"mass\": 0.1}}";
    public UnityEngine.Transform[] logged;
    HandholdLog log;
    UnityEngine.XR.Hands.XRHandSubsystem tracking;

    void OnEnable()
    {
        var path = Path.Combine(UnityEngine.Application.persistentDataPath, "session.jsonl");
        log = new HandholdLog(new StreamWriter(path), objects);
    }

    void OnDisable() { log.Dispose(); }

    // After physics and interaction have moved everything.
    void LateUpdate()
    {
        log.BeginFrame(UnityEngine.Time.unscaledTimeAsDouble);
        if (tracking == null)
        {
            var found = new System.Collections.Generic.List<UnityEngine.XR.Hands.XRHandSubsystem>();
            UnityEngine.SubsystemManager.GetSubsystems(found);
            if (found.Count > 0) tracking = found[0];
        }
        if (tracking != null)
        {
            AddHand(tracking.leftHand, false);
            AddHand(tracking.rightHand, true);
        }
        foreach (var t in logged)
        {
            var p = t.position;
            var q = t.rotation;
            log.Object(t.name, p.x, p.y, p.z, q.x, q.y, q.z, q.w);
        }
        log.EndFrame();
    }

    void AddHand(UnityEngine.XR.Hands.XRHand hand, bool right)
    {
        if (!hand.isTracked) return;
        for (var i = UnityEngine.XR.Hands.XRHandJointID.BeginMarker; i < UnityEngine.XR.Hands.XRHandJointID.EndMarker; i++)
        {
            var joint = hand.GetJoint(i);
            UnityEngine.Pose pose;
            float radius;
            if (!joint.TryGetPose(out pose)) continue;
            if (!joint.TryGetRadius(out radius)) radius = 0;
            log.Joint(i.ToString(), pose.position.x, pose.position.y, pose.position.z, radius);
        }
        log.EndHand(right);
    }
}
#endif
